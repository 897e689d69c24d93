//! The subject of a set: a system, or a system of pairs, by its name in documents.

use dapple_engine::attributes::system::Description;
use dapple_engine::document::systems::of_pairs;
use dapple_engine::rd::System;
use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error};

/// The subject of a set.
#[derive(Clone, Copy, Debug)]
pub enum Swept {
    /// A system whose parameters are drawn.
    System(System),
    /// A system of pairs, for which marks are drawn.
    Pairs(&'static Description),
}

impl Swept {
    /// The description of the system.
    pub fn description(self) -> &'static Description {
        match self {
            Self::System(system) => system.description(),
            Self::Pairs(pairs) => pairs,
        }
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        self.description().name
    }
}

impl PartialEq for Swept {
    fn eq(&self, other: &Self) -> bool {
        self.name() == other.name()
    }
}

impl Serialize for Swept {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

impl<'de> Deserialize<'de> for Swept {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let name = String::deserialize(deserializer)?;
        let system = System::named(&name).map(Self::System);
        let pairs = || of_pairs().find(|pairs| pairs.name == name).map(Self::Pairs);
        system.or_else(pairs).ok_or_else(|| {
            let all = System::ALL.map(System::name).into_iter().chain(of_pairs().map(|pairs| pairs.name));
            let allowed = all.collect::<Vec<_>>().join(", ");
            D::Error::custom(format!("no system is called '{name}'; allowed: {allowed}"))
        })
    }
}
