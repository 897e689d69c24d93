//! Links between pairs of faces that continue each other at an edge.

use super::Repairs;
use crate::grid::UnionFind;
use crate::surface::adjacency::{NONE, next};
use crate::surface::mesh::Mesh;
use crate::surface::vector::{across, dot, minus, unit};

/// By half-edge, the one of the other face at its edge, or [`NONE`]; both may have one direction. If more than two faces meet at an
/// edge, those are linked that continue each other most smoothly.
pub fn links(mesh: &Mesh, repairs: &mut Repairs) -> Vec<u32> {
    let ends = |half: u32| {
        let [a, b] = [half, next(half)].map(|half| mesh.faces[half as usize / 3][half as usize % 3]);
        (a.min(b), a.max(b))
    };
    let mut sorted: Vec<((u32, u32), u32)> =
        (0..3 * mesh.faces.len() as u32).map(|half| (ends(half), half)).collect();
    sorted.sort_unstable();
    let mut links = vec![NONE; sorted.len()];
    for at_edge in sorted.chunk_by(|a, b| a.0 == b.0) {
        let halves: Vec<u32> = at_edge.iter().map(|(_, half)| *half).collect();
        repairs.crowded += usize::from(halves.len() > 2);
        for [a, b] in pairs(mesh, &halves) {
            (links[a as usize], links[b as usize]) = (b, a);
        }
    }
    links
}

/// The pairs of half-edges of one edge: first those with compatible orientations and the flattest angle between the faces.
fn pairs(mesh: &Mesh, halves: &[u32]) -> Vec<[u32; 2]> {
    if let [a, b] = halves {
        return vec![[*a, *b]];
    }
    let mut found: Vec<(bool, f64, [u32; 2])> = Vec::new();
    for (index, a) in halves.iter().enumerate() {
        for b in &halves[index + 1..] {
            let fits = from(mesh, *a) != from(mesh, *b);
            found.push((!fits, flatness(mesh, *a, *b), [*a, *b]));
        }
    }
    found.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)).then(a.2.cmp(&b.2)));
    let mut taken: Vec<u32> = Vec::new();
    found.retain(|(_, _, pair)| {
        let is_free = pair.iter().all(|half| !taken.contains(half));
        taken.extend(pair.iter().filter(|_| is_free));
        is_free
    });
    found.into_iter().map(|(_, _, pair)| pair).collect()
}

fn from(mesh: &Mesh, half: u32) -> u32 {
    mesh.faces[half as usize / 3][half as usize % 3]
}

/// Cosine of the angle between two faces at their edge: −1 if they lie in a plane, 1 if they lie on each other.
fn flatness(mesh: &Mesh, a: u32, b: u32) -> f64 {
    let corner = |half: u32| mesh.positions[from(mesh, half) as usize];
    let Some(edge) = unit(minus(corner(next(a)), corner(a))) else { return 1.0 };
    let inward = |half: u32| unit(across(minus(corner(next(next(half))), corner(half)), edge));
    match (inward(a), inward(b)) {
        (Some(a), Some(b)) => dot(a, b),
        _ => 1.0,
    }
}

/// Gives each fan of linked faces a vertex of its own. Returns the old vertex of each new one.
pub fn detach(mesh: &mut Mesh, links: &[u32], repairs: &mut Repairs) -> Vec<u32> {
    let mut corners = UnionFind::new(links.len());
    for (half, link) in (0..).zip(links).filter(|(half, link)| **link != NONE && half < *link) {
        corners.join(half, next(*link), [0, 0]);
        corners.join(next(half), *link, [0, 0]);
    }
    // Fans by vertex, in the order of their first corners.
    let mut fans: Vec<(u32, u32)> = Vec::new();
    let roots: Vec<u32> = (0..links.len() as u32).map(|corner| corners.find(corner).0).collect();
    for (corner, root) in (0..).zip(&roots).filter(|(corner, root)| corner == *root) {
        fans.push((from(mesh, corner), *root));
    }
    fans.sort_unstable();
    let shared = fans.chunk_by(|a, b| a.0 == b.0).filter(|fans| fans.len() > 1);
    let taken_apart = repairs.crowded + repairs.cut;
    repairs.pinched += if taken_apart == 0 { shared.count() } else { 0 };
    let mut new = vec![0; links.len()];
    fans.iter().enumerate().for_each(|(index, (_, root))| new[*root as usize] = index as u32);
    for (face, roots) in mesh.faces.iter_mut().zip(roots.as_chunks::<3>().0) {
        *face = roots.map(|root| new[root as usize]);
    }
    fans.into_iter().map(|(vertex, _)| vertex).collect()
}
