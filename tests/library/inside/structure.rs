//! Assur groups in solving order, and what fits none, against the definition of independence.

use kinegon::mechanism::structure::{Component, Edge, Structure, structure};
use std::collections::BTreeSet;

fn edges(ends: &[[Option<usize>; 2]]) -> Vec<Edge> {
    ends.iter().map(|&ends| Edge::pin(ends)).collect()
}

/// The joints of a closed chain with some of its bodies known; the others are numbered in their order.
fn with_known(chain: &[[usize; 2]], bodies: usize, known: &[usize]) -> (usize, Vec<Edge>) {
    let unknown: Vec<usize> = (0..bodies).filter(|body| !known.contains(body)).collect();
    let link = |body: usize| unknown.iter().position(|&other| other == body);
    let edges = chain.iter().map(|ends| Edge::pin(ends.map(link))).collect();
    (unknown.len(), edges)
}

fn groups_of(links: usize, edges: &[Edge]) -> Vec<Component> {
    match structure(links, 0, edges) {
        Structure::Groups(groups) => groups,
        misfit @ Structure::Misfit { .. } => panic!("{misfit:?}"),
    }
}

fn links_of(links: usize, edges: &[Edge]) -> Vec<Vec<usize>> {
    groups_of(links, edges).into_iter().map(|group| group.links).collect()
}

fn misfit(under: &[usize], missing: usize, over: &[usize], surplus: usize) -> Structure {
    Structure::Misfit { under: under.to_vec(), missing, over: over.to_vec(), surplus }
}

/// Ternary links 0 and 1 joined to each other and by two chains of two.
const WATT: [[usize; 2]; 7] = [[0, 1], [0, 2], [2, 3], [3, 1], [0, 4], [4, 5], [5, 1]];
/// Ternary links 0 and 1 joined by one link, by another, and by a chain of two.
const STEPHENSON: [[usize; 2]; 7] = [[0, 2], [2, 1], [0, 3], [3, 1], [0, 4], [4, 5], [5, 1]];

#[test]
fn four_bar_is_one_dyad() {
    let joints = edges(&[[None, None], [None, Some(0)], [Some(1), Some(0)], [None, Some(1)]]);
    let dyad = Component { links: vec![0, 1], pins: vec![], joints: vec![1, 2, 3] };
    assert_eq!(structure(2, 0, &joints), Structure::Groups(vec![dyad]));
}

#[test]
fn five_bar_with_two_drivers_is_one_dyad() {
    let (links, joints) = with_known(&[[0, 1], [1, 2], [2, 3], [3, 4], [4, 0]], 5, &[0, 1, 4]);
    assert_eq!(groups_of(links, &joints), [Component { links: vec![0, 1], pins: vec![], joints: vec![1, 2, 3] }]);
}

#[test]
fn watt_is_two_dyads_in_order() {
    // Unknown: 1, 3, 4, 5 become 0, 1, 2, 3.
    let (links, joints) = with_known(&WATT, 6, &[0, 2]);
    let expected = [
        Component { links: vec![0, 1], pins: vec![], joints: vec![0, 2, 3] },
        Component { links: vec![2, 3], pins: vec![], joints: vec![4, 5, 6] },
    ];
    assert_eq!(groups_of(links, &joints), expected);
}

#[test]
fn watt_driven_at_the_far_dyad_follows_dependence_not_numbers() {
    // Ground 4, driver 5: links 0, 1 hang on both and carry 2, 3.
    let (links, joints) = with_known(&WATT, 6, &[4, 5]);
    assert_eq!(links_of(links, &joints), [[0, 1], [2, 3]]);
    // The same with the numbers of the links turned round.
    let turned: Vec<Edge> = joints
        .iter()
        .map(|edge| Edge { ends: edge.ends.map(|end| end.map(|link| 3 - link)), ..edge.clone() })
        .collect();
    assert_eq!(links_of(links, &turned), [[2, 3], [0, 1]]);
}

#[test]
fn stephenson_is_two_dyads_or_a_third_or_fourth_class_group() {
    let (links, joints) = with_known(&STEPHENSON, 6, &[0, 2]);
    assert_eq!(links_of(links, &joints), [[0, 1], [2, 3]]);
    // Ground 0, driver 4: the ternary link 1 with the legs 2, 3, 5.
    let (links, joints) = with_known(&STEPHENSON, 6, &[0, 4]);
    let third = Component { links: vec![0, 1, 2, 3], pins: vec![], joints: vec![0, 1, 2, 3, 5, 6] };
    assert_eq!(groups_of(links, &joints), [third]);
    // Ground 4, driver 5: the ring 0, 2, 1, 3.
    let (links, joints) = with_known(&STEPHENSON, 6, &[4, 5]);
    let fourth = Component { links: vec![0, 1, 2, 3], pins: vec![], joints: vec![0, 1, 2, 3, 4, 6] };
    assert_eq!(groups_of(links, &joints), [fourth]);
}

#[test]
fn ring_held_at_neighbours_is_two_dyads() {
    let joints = edges(&[
        [Some(0), Some(1)],
        [Some(1), Some(2)],
        [Some(2), Some(3)],
        [Some(3), Some(0)],
        [Some(2), None],
        [Some(3), None],
    ]);
    assert_eq!(links_of(4, &joints), [[2, 3], [0, 1]]);
}

#[test]
fn independent_groups_come_by_smallest_link() {
    let mut joints = edges(&[
        [None, Some(3)],
        [Some(3), Some(1)],
        [Some(1), None],
        [Some(2), None],
        [None, Some(0)],
        [Some(0), Some(2)],
    ]);
    assert_eq!(links_of(4, &joints), [[0, 2], [1, 3]]);
    joints.reverse();
    assert_eq!(links_of(4, &joints), [[0, 2], [1, 3]]);
}

#[test]
fn nothing_unknown_is_no_group() {
    assert_eq!(structure(0, 0, &[]), Structure::Groups(Vec::new()));
    assert_eq!(structure(0, 0, &edges(&[[None, None]])), Structure::Groups(Vec::new()));
}

#[test]
fn missing_driver_leaves_all_that_moves() {
    // A four-bar without its driver, and a rigid dyad beside it.
    let joints = edges(&[
        [None, Some(0)],
        [Some(0), Some(1)],
        [Some(1), Some(2)],
        [Some(2), None],
        [None, Some(3)],
        [Some(3), Some(4)],
        [Some(4), None],
    ]);
    assert_eq!(structure(5, 0, &joints), misfit(&[0, 1, 2], 1, &[], 0));
}

#[test]
fn links_without_joints_have_three_free_motions() {
    assert_eq!(structure(2, 0, &[]), misfit(&[0, 1], 6, &[], 0));
    assert_eq!(structure(1, 0, &edges(&[[Some(0), Some(0)]])), misfit(&[0], 3, &[], 0));
}

#[test]
fn dyad_with_a_third_support_is_over_constrained() {
    let joints = edges(&[[None, Some(0)], [Some(0), Some(1)], [Some(1), None], [Some(1), None]]);
    assert_eq!(structure(2, 0, &joints), misfit(&[], 0, &[0, 1], 2));
}

#[test]
fn surplus_and_missing_motion_stand_side_by_side() {
    // Link 0 twice on ground, links 1 and 2 a chain with a free end.
    let joints = edges(&[[None, Some(0)], [None, Some(0)], [None, Some(1)], [Some(1), Some(2)]]);
    assert_eq!(structure(3, 0, &joints), misfit(&[1, 2], 2, &[0], 1));
}

#[test]
fn links_joined_twice_are_found_though_the_numbers_agree() {
    // Three constraints can be assigned to each link, and yet the pair turns about its one pin on the ground.
    let joints = edges(&[[Some(0), Some(1)], [Some(1), Some(0)], [Some(0), None]]);
    assert_eq!(structure(2, 0, &joints), misfit(&[0, 1], 1, &[0, 1], 1));
}

#[test]
fn wedge_moves_but_is_counted_over_constrained() {
    // Known weakness: the three slides allow no rotation of any link, which the count ignores.
    assert_eq!(structure(1, 0, &edges(&[[None, Some(0)], [Some(0), None]])), misfit(&[], 0, &[0], 1));
}

#[test]
fn shared_pin_written_at_a_later_body_joins_groups() {
    // Known weakness: links 0 and 2 and a known body share a pin. Both at the known body: two dyads.
    let rest = edges(&[[Some(0), Some(1)], [Some(1), None], [Some(2), Some(3)], [Some(3), Some(1)]]);
    let with = |pin: [[Option<usize>; 2]; 2]| [edges(&pin), rest.clone()].concat();
    assert_eq!(links_of(4, &with([[None, Some(0)], [None, Some(2)]])), [[0, 1], [2, 3]]);
    assert_eq!(links_of(4, &with([[None, Some(0)], [Some(0), Some(2)]])), [[0, 1], [2, 3]]);
    assert_eq!(links_of(4, &with([[None, Some(2)], [Some(2), Some(0)]])), [[0, 1, 2, 3]]);
}

#[test]
#[should_panic(expected = "joint 0 names a body not below 1")]
fn link_out_of_range_is_refused() {
    structure(1, 0, &edges(&[[Some(1), None]]));
}

#[test]
fn two_hundred_dyads_in_reverse_come_in_order() {
    let count = 200;
    // Dyad d holds links 2 d and 2 d + 1 and hangs on dyad d + 1; the last hangs on known bodies.
    let mut joints = Vec::new();
    for dyad in 0..count {
        let carrier = |side| (dyad + 1 < count).then_some(2 * (dyad + 1) + side);
        let [first, second] = [2 * dyad, 2 * dyad + 1];
        joints.extend(edges(&[[Some(first), carrier(0)], [Some(first), Some(second)], [carrier(1), Some(second)]]));
    }
    let expected: Vec<Component> = (0..count)
        .rev()
        .map(|dyad| Component {
            links: vec![2 * dyad, 2 * dyad + 1],
            pins: vec![],
            joints: (3 * dyad..3 * dyad + 3).collect(),
        })
        .collect();
    assert_eq!(groups_of(2 * count, &joints), expected);
}

/// Independence by its definition: any n bodies share at most 3 n − 3 of the constraints.
fn independent(bodies: usize, constraints: &[[usize; 2]]) -> bool {
    (1_usize..1 << bodies).all(|set| {
        let inside = |ends: &&[usize; 2]| ends.iter().all(|&end| set >> end & 1 == 1);
        constraints.iter().filter(inside).count() <= 3 * set.count_ones() as usize - 3
    })
}

fn rank(bodies: usize, constraints: &[[usize; 2]]) -> usize {
    let mut kept = Vec::new();
    for &ends in constraints {
        kept.push(ends);
        if !independent(bodies, &kept) {
            kept.pop();
        }
    }
    kept.len()
}

fn misfit_by_definition(links: usize, edges: &[Edge]) -> Structure {
    let bodies = links + 1;
    let constraints: Vec<[usize; 2]> = edges
        .iter()
        .map(|edge| (edge.ends.map(|end| end.unwrap_or(links)), edge.constraints))
        .filter(|(ends, _)| ends[0] != ends[1])
        .flat_map(|(ends, constraints)| std::iter::repeat_n(ends, constraints))
        .collect();
    let full = rank(bodies, &constraints);
    let mut over = BTreeSet::new();
    for (index, ends) in constraints.iter().enumerate() {
        let mut others = constraints.clone();
        others.remove(index);
        if rank(bodies, &others) == full {
            over.extend(ends.iter().filter(|&&end| end != links).copied());
        }
    }
    let under = (0..links).filter(|&link| {
        let mut tied = constraints.clone();
        tied.push([link, links]);
        rank(bodies, &tied) > full
    });
    Structure::Misfit {
        under: under.collect(),
        missing: 3 * links - full,
        over: over.into_iter().collect(),
        surplus: constraints.len() - full,
    }
}

/// Whether the groups can be solved in their order and none of them falls into smaller ones.
fn check_groups(edges: &[Edge], groups: &[Component]) {
    let supplied = |joints: &[usize]| joints.iter().map(|&joint| edges[joint].constraints).sum::<usize>();
    let mut solved: BTreeSet<usize> = BTreeSet::new();
    for group in groups {
        let joints_of = |part: &BTreeSet<usize>| -> Vec<usize> {
            let settled = |end: &Option<usize>| end.is_none_or(|link| part.contains(&link) || solved.contains(&link));
            let touches = |end: &Option<usize>| end.is_some_and(|link| part.contains(&link));
            (0..edges.len())
                .filter(|&joint| {
                    let ends = &edges[joint].ends;
                    ends[0] != ends[1] && ends.iter().all(settled) && ends.iter().any(touches)
                })
                .collect()
        };
        for set in 1_usize..(1 << group.links.len()) - 1 {
            let part = (0..group.links.len()).filter(|bit| set >> bit & 1 == 1).map(|bit| group.links[bit]).collect();
            assert!(supplied(&joints_of(&part)) < 3 * part.len(), "{group:?} falls apart");
        }
        let all = group.links.iter().copied().collect();
        assert_eq!(joints_of(&all), group.joints);
        assert_eq!(supplied(&group.joints), 3 * group.links.len());
        solved.extend(all);
    }
}

/// The rank of the velocities' equations with joints at random places, modulo a prime: links have (ω, x, y), pins (x, y).
fn rank_of_velocities(links: usize, pins: usize, edges: &[Edge], mut random: impl FnMut() -> u64) -> usize {
    const PRIME: u64 = 2_147_483_647;
    let places: Vec<[u64; 2]> = (0..pins + edges.len()).map(|_| [random() % PRIME, random() % PRIME]).collect();
    let mut rows = Vec::new();
    for (joint, edge) in edges.iter().enumerate() {
        let pin = edge.ends.iter().flatten().find_map(|body| body.checked_sub(links));
        let [x, y] = places[pin.unwrap_or(pins + joint)];
        for axis in 0..2 {
            let mut row = vec![0; 3 * links + 2 * pins];
            for (end, sign) in edge.ends.iter().zip([1, PRIME - 1]) {
                match *end {
                    Some(link) if link < links => {
                        row[3 * link] = (row[3 * link] + sign * [PRIME - y, x][axis]) % PRIME;
                        row[3 * link + 1 + axis] = (row[3 * link + 1 + axis] + sign) % PRIME;
                    }
                    Some(pin) => row[3 * links + 2 * (pin - links) + axis] = sign,
                    None => {}
                }
            }
            rows.push(row);
        }
    }
    let power = |mut base: u64, mut exponent: u64| {
        let mut product = 1;
        while exponent > 0 {
            if exponent % 2 == 1 {
                product = product * base % PRIME;
            }
            (base, exponent) = (base * base % PRIME, exponent / 2);
        }
        product
    };
    let mut rank = 0;
    for column in 0..3 * links + 2 * pins {
        let Some(pivot) = (rank..rows.len()).find(|&row| rows[row][column] != 0) else { continue };
        rows.swap(rank, pivot);
        let inverse = power(rows[rank][column], PRIME - 2);
        let (done, below) = rows.split_at_mut(rank + 1);
        for row in below {
            let factor = row[column] * inverse % PRIME;
            for (own, other) in row.iter_mut().zip(&done[rank]).skip(column) {
                *own = (*own + (PRIME - factor) * other) % PRIME;
            }
        }
        rank += 1;
    }
    rank
}

/// Joints at random, as many as the links and pins need, with some pins through three or four links.
fn any_joints(random: &mut impl FnMut() -> u64) -> (usize, usize, Vec<Edge>) {
    let links = 4 + random() as usize % 5;
    let pins = 1 + random() as usize % 2;
    let mut joints = Vec::new();
    for pin in 0..pins {
        let mut bodies: Vec<usize> = (0..links).collect();
        for last in (1..links).rev() {
            bodies.swap(last, random() as usize % (last + 1));
        }
        bodies.truncate(3 + random() as usize % 2);
        joints.extend(bodies.iter().map(|&body| Edge::pin([Some(body), Some(links + pin)])));
    }
    while 2 * joints.len() < 3 * links + 2 * pins {
        let first = random() as usize % links;
        let second = (first + 1 + random() as usize % (links + 1)) % (links + 2);
        joints.push(Edge::pin([Some(first), Some(second).filter(|&link| link < links)]));
    }
    (links, pins, joints)
}

/// Dyads, each joined to the frame or to earlier links or pins. Half of the time one end is then moved to another link. Most of the results split into groups.
fn dyads(random: &mut impl FnMut() -> u64) -> (usize, usize, Vec<Edge>) {
    let links = 2 * (2 + random() as usize % 3);
    let mut pins = 0;
    let mut joints = Vec::new();
    for first in (0..links).step_by(2) {
        for link in [first, first + 1] {
            let on = random() as usize % (first + pins + 1);
            let on = if on < first { Some(on) } else { Some(links + on - first).filter(|&pin| pin < links + pins) };
            joints.push(Edge::pin([Some(link), on]));
        }
        if random().is_multiple_of(2) {
            joints.extend([first, first + 1].map(|link| Edge::pin([Some(link), Some(links + pins)])));
            pins += 1;
        } else {
            joints.push(Edge::pin([Some(first), Some(first + 1)]));
        }
    }
    if random().is_multiple_of(2) {
        let (moved, link) = (random() as usize % joints.len(), random() as usize % links);
        if joints[moved].ends[1] != Some(link) {
            joints[moved].ends[0] = Some(link);
        }
    }
    (links, pins, joints)
}

/// Pins through three and more links: freedoms and surplus constraints are those of the velocities, and the groups are the same in every order.
#[test]
fn pins_of_several_links_are_points() {
    let mut state = 7_u64;
    let mut random = move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        state >> 33
    };
    let (mut grouped, mut misfits) = (0, 0);
    for number in 0..3000 {
        let (links, pins, mut joints) = if number % 2 == 0 { any_joints(&mut random) } else { dyads(&mut random) };
        let rank = rank_of_velocities(links, pins, &joints, &mut random);
        let free = 3 * links + 2 * pins - rank;
        let spare = 2 * joints.len() - rank;
        let found = structure(links, pins, &joints);
        match &found {
            Structure::Groups(groups) => {
                grouped += 1;
                assert_eq!([free, spare], [0, 0], "{joints:?}");
                for group in groups {
                    let supplied = 2 * group.joints.len();
                    assert_eq!(supplied, 3 * group.links.len() + 2 * group.pins.len(), "{group:?} of {joints:?}");
                }
                joints.reverse();
                let order =
                    |groups: &[Component]| groups.iter().map(|g| (g.links.clone(), g.pins.clone())).collect::<Vec<_>>();
                match structure(links, pins, &joints) {
                    Structure::Groups(others) => assert_eq!(order(groups), order(&others), "{joints:?}"),
                    misfit @ Structure::Misfit { .. } => panic!("{misfit:?}"),
                }
            }
            Structure::Misfit { missing, surplus, .. } => {
                misfits += 1;
                assert_eq!([free, spare], [*missing, *surplus], "{joints:?}");
            }
        }
    }
    assert!(grouped > 300 && misfits > 200, "{grouped} {misfits}");
}

#[test]
fn random_structures_agree_with_the_definition() {
    let mut state = 1_u64;
    let mut below = |limit: usize| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % limit
    };
    let (mut grouped, mut misfits, mut largest) = (0, 0, 0);
    for round in 0..2000 {
        // Near the right number of joints, where groups and local surplus are both common.
        let links = [1, 2, 2, 3, 4, 4, 4, 4][below(8)];
        let spare = [0_usize, 0, 0, 0, 0, 0, 1, 2][below(8)];
        let count = 3 * links / 2 + spare - below(8) / 7;
        let mut ends = || {
            let first = below(links);
            let second = (first + 1 + below(links + 1)) % (links + 2);
            [Some(first), Some(second).filter(|&link| link < links)]
        };
        let mut joints: Vec<Edge> = (0..count).map(|_| Edge::pin(ends())).collect();
        // In a third of them, two joints of one constraint replace one of two.
        if let Some(joint) = joints.first_mut().filter(|_| round % 3 == 0) {
            joint.constraints = 1;
            joints.push(Edge { constraints: 1, ..Edge::pin(ends()) });
        }
        let found = structure(links, 0, &joints);
        match &found {
            Structure::Groups(groups) => {
                grouped += 1;
                largest = largest.max(groups.iter().map(|group| group.links.len()).max().unwrap_or(0));
                check_groups(&joints, groups);
                assert_eq!(misfit_by_definition(links, &joints), misfit(&[], 0, &[], 0));
                for joint in &mut joints {
                    joint.ends.reverse();
                }
                assert_eq!(structure(links, 0, &joints), found, "{joints:?}");
                joints.reverse();
                let order: Vec<Vec<usize>> = groups.iter().map(|group| group.links.clone()).collect();
                assert_eq!(links_of(links, &joints), order, "{joints:?}");
            }
            Structure::Misfit { .. } => {
                misfits += 1;
                assert_eq!(found, misfit_by_definition(links, &joints), "{joints:?}");
                joints.reverse();
                assert_eq!(structure(links, 0, &joints), found, "{joints:?}");
            }
        }
    }
    assert!(grouped > 100 && misfits > 1000 && largest >= 4, "{grouped} {misfits} {largest}");
}
