use super::made_up_tests::MADE_UP;
use super::*;
use crate::attributes::system::Family;
use crate::document::{AreaKind, LineKind, MapKey, OptionKey};

#[test]
fn descriptions_are_distinct_and_name_existing_keys() {
    for system in SYSTEMS {
        assert_eq!(named(system.name), Some(system), "two are called {}", system.name);
        assert!(system.option_keys.iter().all(|key| OptionKey::ALL.iter().any(|one| one.name() == *key)));
        for keys in system.own_keys.iter().chain(system.refused_keys) {
            let is_known = |key: &&str| match key.split_once('.') {
                Some(("options", key)) => OptionKey::ALL.iter().any(|one| one.name() == key),
                Some(("maps", key)) => MapKey::ALL.iter().any(|one| one.name() == key),
                _ => ["points", "tone"].contains(key),
            };
            assert!(keys.keys.iter().all(is_known), "{system:?}: {keys:?}");
        }
    }
}

#[test]
fn systems_that_own_a_key_together_give_one_reason() {
    let real = || SYSTEMS.iter().filter(|system| ***system != MADE_UP);
    for own in real().flat_map(|system| system.own_keys) {
        for key in own.keys {
            let mut others = real().flat_map(|system| system.own_keys);
            assert!(others.all(|other| !other.keys.contains(key) || other.reason == own.reason), "{key}");
        }
    }
}

#[test]
fn each_system_belongs_to_its_family() {
    let real = || SYSTEMS.iter().copied().filter(|system| **system != MADE_UP);
    assert!(of_parameters().eq(System::ALL.into_iter().map(System::description)));
    for system in real() {
        let is_known = match system.kind {
            Family::Marks => System::named(system.name).is_some(),
            Family::Pairs => PairKind::of(system).is_some(),
            Family::Areas => AreaKind::of(system).is_some(),
            Family::Lines => LineKind::of(system).is_some(),
            Family::Points => *system == POINTS,
            Family::Growth => system == TURING_GROWTH,
        };
        assert!(is_known, "{system:?}");
    }
    let kinds = PairKind::ALL.len() + AreaKind::ALL.len() + LineKind::ALL.len();
    assert_eq!(real().count(), System::ALL.len() + kinds + 2);
}
