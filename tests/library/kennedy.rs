//! Kennedy's lines: that they lead to every centre of all chains with one freedom and four, six or eight links, with the fewest crossings; and that
//! the centres constructed are those of independent digits, and those of the computed motion within what is allowed.

use kinegon::Solution;
use kinegon::centers::LinkPair;
use kinegon::construction::kennedy::chain::{Homogeneous, Places, Way, ways};
use kinegon::construction::kennedy::order::{Crossed, Diagram, Lines, Two, reach, shortest, two};
use kinegon::construction::{CenterOrigin, Centers, FigureOf};
use kinegon::geometry::{Place, span};
use kinegon::mechanism::{BodyId, GROUND};
use nalgebra::{DMatrix, Vector2};
use serde_json::{Value, json};
use std::collections::BTreeSet;
use support::files;
use support::planted::{Planted, pattern};
use support::random::Random;
use support::stages::solved;
use support::survey::CONSTRUCTED;

type Chain = Vec<Two>;

/// All chains of so many links with one freedom, pins between two links each, and no part that is rigid by itself, up to names.
fn chains(links: usize) -> Vec<Chain> {
    let joints = (3 * links - 4) / 2;
    let mut found = Vec::new();
    let mut seen = BTreeSet::new();
    for degrees in degrees(links, 2 * joints) {
        let mut all = Vec::new();
        fill(&degrees, 0, &mut vec![0; links], &mut Vec::new(), &mut all);
        for chain in all.into_iter().filter(|chain| is_movable(links, chain)) {
            if seen.insert(canonical(&degrees, &chain)) {
                found.push(chain);
            }
        }
    }
    found
}

/// Numbers of joints of the links, falling, at least two each.
fn degrees(links: usize, sum: usize) -> Vec<Vec<usize>> {
    fn go(left: usize, sum: usize, most: usize, so_far: &mut Vec<usize>, all: &mut Vec<Vec<usize>>) {
        if left == 0 {
            if sum == 0 {
                all.push(so_far.clone());
            }
            return;
        }
        for degree in 2..=most.min(sum) {
            so_far.push(degree);
            go(left - 1, sum - degree, degree, so_far, all);
            so_far.pop();
        }
    }
    let mut all = Vec::new();
    go(links, sum, links / 2, &mut Vec::new(), &mut all);
    all
}

fn fill(degrees: &[usize], from: usize, used: &mut Vec<usize>, chain: &mut Chain, all: &mut Vec<Chain>) {
    let Some(link) = (from..degrees.len()).find(|&link| used[link] < degrees[link]) else {
        if used == degrees {
            all.push(chain.clone());
        }
        return;
    };
    if link > from && used[from] != degrees[from] {
        return;
    }
    let least = chain.iter().filter(|pair| pair[0] == link).map(|pair| pair[1]).max().unwrap_or(link);
    for other in least + 1..degrees.len() {
        if used[other] < degrees[other] {
            chain.push([link, other]);
            (used[link], used[other]) = (used[link] + 1, used[other] + 1);
            fill(degrees, link, used, chain, all);
            (used[link], used[other]) = (used[link] - 1, used[other] - 1);
            chain.pop();
        }
    }
}

/// Whether it hangs together and no two or more links share too many joints.
fn is_movable(links: usize, chain: &Chain) -> bool {
    let rigid = (1_usize..1 << links).any(|part| {
        let count = part.count_ones() as usize;
        let inside = chain.iter().filter(|pair| pair.iter().all(|link| part >> link & 1 == 1)).count();
        count > 1 && count < links && 2 * inside + 4 > 3 * count
    });
    let mut reached = 1_usize;
    for _ in 0..links {
        for [a, b] in chain {
            if reached >> a & 1 == 1 || reached >> b & 1 == 1 {
                reached |= 1 << a | 1 << b;
            }
        }
    }
    !rigid && reached == (1 << links) - 1
}

/// The least list of edges under all exchanges of links with as many joints.
fn canonical(degrees: &[usize], chain: &Chain) -> Chain {
    fn go(degrees: &[usize], named: &mut Vec<usize>, chain: &Chain, best: &mut Option<Chain>) {
        if named.len() == degrees.len() {
            let mut other: Chain = chain.iter().map(|pair| two(named[pair[0]], named[pair[1]])).collect();
            other.sort_unstable();
            if best.as_ref().is_none_or(|best| other < *best) {
                *best = Some(other);
            }
            return;
        }
        let own = degrees[named.len()];
        for name in (0..degrees.len()).filter(|name| degrees[*name] == own) {
            if !named.contains(&name) {
                named.push(name);
                go(degrees, named, chain, best);
                named.pop();
            }
        }
    }
    let mut best = None;
    go(degrees, &mut Vec::new(), chain, &mut best);
    best.expect("one of them is the least")
}

/// The centres of a chain in a random position: places of the joints, and all centres by its twists.
fn placed(links: usize, chain: &Chain, random: &mut Random) -> (Places, Vec<Vec<[f64; 3]>>) {
    let mut places = Places::new(links);
    // Twists (ω, vx, vy) of all links but the first, which rests.
    let mut equations = DMatrix::<f64>::zeros(2 * chain.len() + 1, 3 * links);
    for (row, &[a, b]) in chain.iter().enumerate() {
        let [x, y] = random.place();
        places.put([a, b], Homogeneous::at(x, y));
        for (link, sign) in [(a, 1.0), (b, -1.0)] {
            equations[(2 * row, 3 * link)] = -sign * y;
            equations[(2 * row, 3 * link + 1)] = sign;
            equations[(2 * row + 1, 3 * link)] = sign * x;
            equations[(2 * row + 1, 3 * link + 2)] = sign;
        }
    }
    let moving = equations.columns(3, 3 * links - 3).into_owned();
    let svd = moving.svd(false, true);
    let null = svd.v_t.expect("asked for");
    let motion = null.row(null.nrows() - 1).transpose();
    let twist = |link: usize| match link {
        0 => [0.0; 3],
        link => [0, 1, 2].map(|part| motion[3 * link - 3 + part]),
    };
    let center = |a: usize, b: usize| {
        let [a, b] = [twist(a), twist(b)];
        // v + ω × P = 0.
        [-(b[2] - a[2]), b[1] - a[1], b[0] - a[0]]
    };
    let all = (0..links).map(|a| (0..links).map(|b| center(a, b)).collect()).collect();
    (places, all)
}

/// The distance of a place from a centre as vectors of the projective plane.
fn apart(place: Homogeneous, truth: [f64; 3]) -> f64 {
    let [x, y] = place.place();
    let own = if place.is_at_infinity() { [x, y, 0.0] } else { [x, y, 1.0] };
    let [a, b] = [own, truth].map(|v| v.map(|part| part / size(v)));
    let cross = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    size(cross)
}

fn size([a, b, c]: [f64; 3]) -> f64 {
    libm::hypot(libm::hypot(a, b), c)
}

fn pairs(links: usize) -> Vec<Two> {
    (0..links).flat_map(|a| (a + 1..links).map(move |b| [a, b])).collect()
}

/// `tests/centers` counts the chains, and names those of which lines alone leave centres out.
#[test]
fn every_center_of_all_chains() {
    let mut random = Random(3);
    let mut worst: f64 = 0.0;
    for counted in serde_json::from_str::<Vec<Value>>(&files::read("tests/centers/chains.json")).expect("chains") {
        let links = counted["links"].as_u64().expect("a number") as usize;
        let all = chains(links);
        assert_eq!(all.len() as u64, counted["chains"], "chains of {links} links");
        let mut stuck = Vec::new();
        for chain in &all {
            let wanted = pairs(links);
            let (joints, truth) = placed(links, chain, &mut random);
            let by_lines = ways(chain, &mut joints.clone(), &wanted, false);
            let missing = wanted.len() - chain.len() - by_lines.len();
            if missing > 0 {
                stuck.push((by_lines.len(), missing));
            }
            let mut places = joints;
            let found = ways(chain, &mut places, &wanted, true);
            assert_eq!(found.len(), wanted.len() - chain.len(), "{chain:?}");
            assert_eq!(found.iter().any(|way| matches!(way, Way::LeftOut(_))), missing > 0, "{chain:?}");
            for &[a, b] in &wanted {
                let place = places.get([a, b]).expect("every centre");
                worst = worst.max(apart(place, truth[a][b]));
            }
        }
        let told = counted["stuck"].as_array().expect("a list").iter();
        let mut told: Vec<(usize, usize)> = told
            .map(|chain| ["found", "missing"].map(|key| chain[key].as_u64().expect("a number") as usize).into())
            .collect();
        stuck.sort_unstable();
        told.sort_unstable();
        assert_eq!(stuck, told);
    }
    println!("worst {worst:e}");
    assert!(worst < 1e-7, "{worst:e}");
}

/// Every crossing is as good as any other.
struct Alike;

impl Lines for Alike {
    fn sine(&self, _: &Crossed) -> Option<f64> {
        Some(1.0)
    }

    fn mark(&mut self, _: &Crossed) {}
}

/// The least number of centres that lead to one, by trying all sets of them.
fn least(links: usize, chain: &Chain, wanted: Two) -> usize {
    let missing: Vec<Two> = pairs(links).into_iter().filter(|pair| !chain.contains(pair)).collect();
    let leads = |set: usize| {
        let mut diagram = Diagram::new(links, chain.iter().copied());
        loop {
            let next = missing.iter().enumerate().find(|&(index, &[i, j])| {
                let both = |k: &usize| *k != i && *k != j && diagram.has(two(i, *k)) && diagram.has(two(j, *k));
                set >> index & 1 == 1 && !diagram.has([i, j]) && (0..links).filter(both).count() > 1
            });
            match next {
                Some((_, &pair)) => diagram.add(pair),
                None => return diagram.has(wanted),
            }
        }
    };
    let sets = (0_usize..1 << missing.len()).filter(|set| leads(*set));
    sets.map(|set| set.count_ones() as usize).min().expect("it is reached")
}

#[test]
fn with_the_fewest_crossings() {
    for links in [4, 6] {
        for chain in chains(links) {
            let known = Diagram::new(links, chain.iter().copied());
            let reached = reach(&mut known.clone(), &mut Alike);
            for wanted in known.missing() {
                let found = shortest(&known, &reached, &[wanted], &Alike);
                assert_eq!(found.last().map(|crossed| crossed.center), Some(wanted));
                let mut diagram = known.clone();
                for crossed in &found {
                    assert!(crossed.needs().iter().all(|need| diagram.has(*need)), "{found:?}");
                    diagram.add(crossed.center);
                }
                assert_eq!(found.len(), least(links, &chain, wanted), "{chain:?}: {wanted:?} by {found:?}");
            }
        }
    }
}

/// The scene with all its centres on the only panel.
fn with_centers(scene: &Value) -> Solution {
    let mut scene = scene.clone();
    scene["figure"] = json!({ "panels": ["centers"], "centers": "all" });
    solved(&scene.to_string()).unwrap_or_else(|error| panic!("{scene}: {error}"))
}

fn centers(solution: &Solution) -> &Centers {
    solution.construction.centers.as_deref().expect("the figure asks for them")
}

fn digits(value: &Value) -> Vector2<f64> {
    let number = |axis: usize| value[axis].as_str().expect("digits").parse::<f64>().expect("a number");
    Vector2::new(number(0), number(1))
}

#[test]
fn constructed_is_true() {
    let (mut compared, mut far) = (0, 0);
    for line in files::read("tests/centers/cases.jsonl").lines() {
        let case: Value = serde_json::from_str(line).expect("a case");
        let (id, expected) = (&case["id"], &case["expected"]);
        let solution = with_centers(&case["scene"]);
        let centers = centers(&solution);
        let size = span(solution.pose.points.iter().copied());
        for (name, truth) in expected["centers"].as_object().expect("centres") {
            let permanent = expected["permanent"].get(name);
            let pair = kinegon::centers::LinkPair::named(name, &solution.mechanism).expect("a pair");
            let by_rates = || centers.by_rates.iter().find(|(own, _)| *own == pair).expect(name).1;
            let place = centers.of(pair).map_or_else(by_rates, |id| Some(centers.get(id).place));
            match (place, truth.get("at"), truth.get("at_infinity")) {
                (Some(Place::At(place)), Some(at), _) => {
                    let off = (place.coords - digits(at)).norm();
                    assert!(off <= 1e-10 * size.max(digits(at).norm()), "{id}: {name} is {off:e} off");
                    compared += 1;
                }
                (Some(Place::AtInfinity(along)), _, Some(truth)) => {
                    let off = along.normalize().perp(&digits(truth)).abs();
                    assert!(off <= 1e-9, "{id}: {name} is {off:e} off its direction");
                    far += 1;
                }
                // A pin between links that are at rest on one another.
                (Some(Place::At(_)), None, None) if permanent.is_some() => {}
                (None, None, None) => {}
                (place, ..) => panic!("{id}: {name} is {place:?}, not {truth}"),
            }
        }
        let count = centers.all.iter().filter(|center| !center.is_permanent()).count();
        let order = expected["kennedy_order"].as_array().expect("an order").len();
        let left_out = centers.all.iter().any(|center| center.figure != FigureOf::Mechanism);
        assert!(left_out || count == order, "{id}: {count} centres by lines, not {order}");
        let agreement = centers.agreement;
        assert!(agreement.is_none_or(|a| a.difference <= a.allowed), "{id}: {agreement:?}");
    }
    println!("{compared} compared, {far} at infinity");
    assert!(compared > 150 && far > 8);
}

/// What is left out where a link is missing: two places of a centre on a line that crosses the link's.
#[test]
fn a_link_left_out() {
    let text = files::read("tests/centers/cases.jsonl");
    let line = text.lines().find(|line| line.contains("I02-single-flier")).expect("it is there");
    let solution = with_centers(&serde_json::from_str::<Value>(line).expect("a case")["scene"]);
    let centers = centers(&solution);
    assert!(centers.by_rates.is_empty());
    let ways = centers.all.iter().filter(|center| match &center.origin {
        CenterOrigin::Lines { lines, .. } => lines[0].over.is_none(),
        _ => false,
    });
    assert_eq!(ways.count(), 1);
}

/// Whether the three centres of any three links lie on a line, as far as the crossings allow; how many triples were at places.
fn are_on_lines(solution: &Solution, ids: &[BodyId], size: f64, allowed: f64, scene: &Value) -> usize {
    let (centers, origin) = (centers(solution), solution.construction.origin);
    let place = |a: BodyId, b: BodyId| {
        let center = centers.get(centers.of(LinkPair::new(a, b)?)?);
        center.place.finite()
    };
    let mut count = 0;
    for (i, &a) in ids.iter().enumerate() {
        for (j, &b) in ids.iter().enumerate().skip(i + 1) {
            for &c in &ids[j + 1..] {
                let (Some(p), Some(q), Some(r)) = (place(a, b), place(b, c), place(a, c)) else { continue };
                // The smallest height of their triangle, in parts of the size that the places have.
                let sides = [q - p, r - q, p - r];
                let longest = sides.iter().map(|side| side.norm()).fold(0.0, f64::max);
                let reach = [p, q, r].iter().map(|at| (at - origin).norm()).fold(size, f64::max);
                let height = if longest > 0.0 { sides[0].perp(&sides[1]).abs() / longest } else { 0.0 };
                assert!(height <= 8.0 * allowed * reach, "{scene}: {height:e} of {reach:e}, allowed {allowed:e}");
                count += 1;
            }
        }
    }
    count
}

#[test]
fn of_random_mechanisms() {
    let mut random = Random(11);
    let (mut made, mut lines, mut triples) = (0, 0, 0);
    for class in ["II", "III", "IV"] {
        let mut of_class = 0;
        while of_class < CONSTRUCTED.now() {
            let (kinds, joints) = pattern(&mut random, class);
            let text = Planted::new(&mut random, &kinds, &joints).scene();
            let mut scene: Value = serde_json::from_str(&text).expect("a scene");
            scene["figure"] = json!({ "panels": ["centers"], "centers": "all" });
            let Ok(solution) = solved(&scene.to_string()) else { continue };
            // A group on the frame or on the crank alone rests on it: its other centres lie on no line.
            let size = span(solution.pose.points.iter().copied());
            let ids: Vec<BodyId> =
                std::iter::once(GROUND).chain(solution.mechanism.links().map(|(id, _)| id)).collect();
            let rests = |a: BodyId, b: BodyId| {
                let [a, b] = [a, b].map(|id| *solution.motion.body(id));
                let at = solution.pose.points[0];
                (a.omega - b.omega).abs() <= 1e-9 && (a.velocity_at(at) - b.velocity_at(at)).norm() <= 1e-9 * size
            };
            if ids.iter().enumerate().any(|(index, &a)| ids[index + 1..].iter().any(|&b| rests(a, b))) {
                continue;
            }
            let centers = centers(&solution);
            (made, of_class) = (made + 1, of_class + 1);
            lines += centers.all.iter().filter(|center| !center.is_permanent()).count();
            assert!(centers.by_rates.is_empty(), "{scene}: {:?}", centers.by_rates);
            if let Some(agreement) = centers.agreement {
                assert!(agreement.difference <= agreement.allowed, "{scene}: {agreement:?}");
                assert!(agreement.allowed < 1e-3, "{scene}: {agreement:?}");
                triples += are_on_lines(&solution, &ids, size, agreement.allowed, &scene);
            }
        }
    }
    println!("{made} mechanisms, {lines} centres by lines, {triples} triples of centres on lines");
    assert!(made == 3 * CONSTRUCTED.now() && lines > 5 * made && triples > 5 * made);
}
