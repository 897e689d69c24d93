//! Room for drawn spots that have not grown.

use super::correctable::Correctable;
use super::found::DrawnSpots;
use super::restarts::Restart;

/// What makes room for lost spots.
#[derive(Default)]
pub struct Room {
    /// Spots that are taken away.
    away: Vec<usize>,
    /// Spots that begin again.
    again: Vec<usize>,
}

impl Room {
    /// The room that is made for the `lost` spots: the nearest spot that was not drawn is taken from beside each, and it begins
    /// again at the same time as the nearest drawn one, since beside one that has already grown it would die again.
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

    /// Whether none can be made.
    pub fn is_none(&self) -> bool {
        self.again.is_empty()
    }

    /// Makes it. The other drawn spots that are corrected, or begin again, do so at the same time.
    pub fn made(self, drawn: &DrawnSpots) -> Restart {
        let Self { away, again: undo } = self;
        let others = drawn.lost.iter().filter(|index| !undo.contains(index));
        let again = undo.iter().chain(others).copied().collect();
        Restart { correct: true, undo, away, again, changed: drawn.different.clone(), ..Restart::default() }
    }
}
