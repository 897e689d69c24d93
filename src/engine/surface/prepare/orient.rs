//! Compatible orientations of faces, pointing outwards.

use super::Repairs;
use crate::surface::adjacency::NONE;
use crate::surface::mesh::{Mesh, area_vector};
use crate::surface::vector::{cross, dot, length, minus};

/// Reverses faces so that linked ones are compatible, and each part so that it encloses a positive volume; an open part keeps the
/// orientation of most of its area. Links where no orientation fits are cut. Returns the links, which are twins then.
pub fn orient(mesh: &mut Mesh, mut links: Vec<u32>, repairs: &mut Repairs) -> Vec<u32> {
    let from = |half: u32| mesh.faces[half as usize / 3][half as usize % 3];
    let mut turned: Vec<Option<bool>> = vec![None; mesh.faces.len()];
    for first in 0..mesh.faces.len() {
        if turned[first].is_some() {
            continue;
        }
        turned[first] = Some(false);
        // Breadth-first, so that a one-sided strip is cut straight across.
        let mut part = vec![first];
        let mut next = 0;
        while next < part.len() {
            let face = part[next];
            next += 1;
            for half in 3 * face as u32..3 * face as u32 + 3 {
                let link = links[half as usize];
                if link == NONE {
                    continue;
                }
                let beyond = link as usize / 3;
                let runs_along = from(half) == from(link);
                let wanted = turned[face] != Some(runs_along);
                match turned[beyond] {
                    None => {
                        turned[beyond] = Some(wanted);
                        part.push(beyond);
                    }
                    Some(is) if is != wanted => {
                        (links[half as usize], links[link as usize]) = (NONE, NONE);
                        repairs.cut += 1;
                    }
                    Some(_) => {}
                }
            }
        }
        if is_inside_out(mesh, &part, &turned, &links) {
            part.iter().for_each(|face| turned[*face] = turned[*face].map(|turned| !turned));
        }
    }
    let turned: Vec<bool> = turned.into_iter().map(|turned| turned == Some(true)).collect();
    repairs.turned += turned.iter().filter(|turned| **turned).count();
    for (face, _) in mesh.faces.iter_mut().zip(&turned).filter(|(_, turned)| **turned) {
        face.swap(1, 2);
    }
    // The half-edges of a reversed face have the opposite order.
    let new = |half: usize| if turned[half / 3] { half / 3 * 3 + 2 - half % 3 } else { half };
    let mut twins = vec![NONE; links.len()];
    for (half, link) in links.iter().enumerate().filter(|(_, link)| **link != NONE) {
        twins[new(half)] = new(*link as usize) as u32;
    }
    twins
}

/// Whether a part with compatible orientations must be reversed as a whole.
fn is_inside_out(mesh: &Mesh, part: &[usize], turned: &[Option<bool>], links: &[u32]) -> bool {
    let is_closed = part.iter().all(|face| links[3 * face..3 * face + 3].iter().all(|link| *link != NONE));
    let middle = mesh.positions[mesh.faces[part[0]][0] as usize];
    let (mut volume, mut kept) = (0.0, 0.0);
    for face in part {
        let [a, b, c] = mesh.corners(*face).map(|corner| minus(corner, middle));
        let sign = if turned[*face] == Some(true) { -1.0 } else { 1.0 };
        volume += sign * dot(a, cross(b, c));
        kept += sign * length(area_vector([a, b, c]));
    }
    // A flat double-sided part has no volume that tells its sides apart.
    if is_closed && volume != 0.0 { volume < 0.0 } else { kept < 0.0 }
}
