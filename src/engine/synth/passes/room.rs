//! Room for drawn spots that have not grown.

use super::correctable::Correctable;
use super::found::DrawnSpots;
use super::restarts::Restart;

/// The changes that make room for lost spots.
#[derive(Default)]
pub struct Room {
    /// Spots that are removed.
    away: Vec<usize>,
    /// Spots that are restarted.
    again: Vec<usize>,
}

impl Room {
    /// The changes that make room for the `lost` spots: beside each, the nearest spot that was not drawn is removed, and the
    /// nearest drawn one is restarted together with it. Beside a neighbour that has already grown it would vanish again.
    pub fn beside(layer: &impl Correctable, lost: &[usize]) -> Self {
        let mut room = Self::default();
        for index in lost {
            let [drawn, other] = layer.beside(*index);
            if other.or(drawn).is_some() {
                room.away.extend(other);
                room.again.extend(drawn);
                room.again.push(*index);
            }
        }
        for indices in [&mut room.away, &mut room.again] {
            indices.sort_unstable();
            indices.dedup();
        }
        room
    }

    /// Whether no room can be made.
    pub fn is_none(&self) -> bool {
        self.again.is_empty()
    }

    /// The restart that makes the room. Other drawn spots that are corrected or restarted are included.
    pub fn made(self, drawn: &DrawnSpots) -> Restart {
        let Self { away, again: undo } = self;
        let others = drawn.lost.iter().filter(|index| !undo.contains(index));
        let again = undo.iter().chain(others).copied().collect();
        Restart { correct: true, undo, away, again, changed: drawn.different.clone(), ..Restart::default() }
    }
}
