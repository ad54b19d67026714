//! Changes of scenes as trees of JSON, so that what comes out is JSON again and often still a scene.
#![allow(dead_code)] // not every target uses all of it

use std::sync::LazyLock;

use kinegon::scene::Scene;
use serde_json::{Value, json};

use super::odd;
use super::random::Random;

/// Numbers at which something may change.
const NUMBERS: [f64; 20] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    2.0,
    45.0,
    90.0,
    180.0,
    270.0,
    360.0,
    -180.0,
    1e-9,
    1e9,
    1e-160,
    1e160,
    1e-300,
    1e300,
    5e-324,
    f64::MAX,
];

/// All keys and words that the schema of scenes knows.
static WORDS: LazyLock<Vec<String>> = LazyLock::new(|| {
    let mut words = Vec::new();
    collect(&Scene::schema(), &mut words);
    words.retain(|word| word.len() <= 20 && !word.contains([' ', '$', '#', '/']));
    words.sort();
    words.dedup();
    words
});

/// Texts of values and keys.
fn collect(node: &Value, texts: &mut Vec<String>) {
    match node {
        Value::String(text) => texts.push(text.clone()),
        Value::Array(elements) => elements.iter().for_each(|element| collect(element, texts)),
        Value::Object(entries) => {
            for (key, value) in entries {
                texts.push(key.clone());
                collect(value, texts);
            }
        }
        _ => {}
    }
}

/// Lines of a text that is no JSON, changed as lines and cells: doubled, exchanged, emptied, made odd.
pub fn mutate_lines(data: &mut [u8], size: usize, max_size: usize, seed: u32) -> usize {
    let mut dice = Random(seed.into());
    let text = String::from_utf8_lossy(&data[..size]).into_owned();
    let mut lines: Vec<String> = text.split('\n').map(str::to_owned).collect();
    for _ in 0..=dice.below(3) {
        let at = dice.below(lines.len());
        match dice.below(6) {
            0 if lines.len() > 1 => _ = lines.remove(at),
            1 => lines.insert(at, lines[at].clone()),
            2 => lines[at] = odd::text(&mut dice),
            3 => {
                let other = dice.below(lines.len());
                lines.swap(at, other);
            }
            _ => {
                let mark = *pick(&[',', ';', '\t', '(', ' '], &mut dice).expect("there are some");
                let mut cells: Vec<String> = lines[at].split(mark).map(str::to_owned).collect();
                let cell = dice.below(cells.len());
                cells[cell] = match dice.below(3) {
                    0 => NUMBERS[dice.below(NUMBERS.len())].to_string(),
                    1 => cells[dice.below(cells.len())].clone(),
                    _ => odd::text(&mut dice),
                };
                lines[at] = cells.join(&mark.to_string());
            }
        }
    }
    let text = lines.join("\n");
    if text.len() > max_size.min(data.len()) {
        return libfuzzer_sys::fuzzer_mutate(data, size, max_size);
    }
    data[..text.len()].copy_from_slice(text.as_bytes());
    text.len()
}

/// Changes the scene in `data[..size]` in one to four places; gives its new size. What is no JSON is handed to the fuzzer.
pub fn mutate(data: &mut [u8], size: usize, max_size: usize, seed: u32) -> usize {
    let Ok(mut scene) = serde_json::from_slice::<Value>(&data[..size]) else {
        return libfuzzer_sys::fuzzer_mutate(data, size, max_size);
    };
    let mut dice = Random(seed.into());
    for _ in 0..=dice.below(2) + dice.below(3) {
        change(&mut scene, &mut dice);
    }
    let text = scene.to_string();
    if text.len() > max_size.min(data.len()) {
        return libfuzzer_sys::fuzzer_mutate(data, size, max_size);
    }
    data[..text.len()].copy_from_slice(text.as_bytes());
    text.len()
}

/// Puts a part of the other scene into the one, in place of a part with the same key where there is one.
pub fn cross(one: &[u8], other: &[u8], out: &mut [u8], seed: u32) -> usize {
    let mut dice = Random(seed.into());
    let trees = [one, other].map(|data| serde_json::from_slice::<Value>(data).ok());
    let [Some(mut scene), Some(mut other)] = trees else {
        return 0;
    };
    let holders = |scene: &mut Value, key: Option<&str>| {
        (0..nodes(scene))
            .filter(|&n| {
                let object = nth(scene, n).and_then(|node| node.as_object());
                object.is_some_and(|entries| {
                    key.map_or(!entries.is_empty(), |key| entries.contains_key(key))
                })
            })
            .collect::<Vec<_>>()
    };
    let sources = holders(&mut other, None);
    let Some(&from) = pick(&sources, &mut dice) else {
        return 0;
    };
    let entries = nth(&mut other, from)
        .and_then(|node| node.as_object())
        .expect("it was one");
    let (key, part) = entries
        .iter()
        .nth(dice.below(entries.len()))
        .expect("it has one");
    let targets = holders(&mut scene, Some(key));
    let to = pick(&targets, &mut dice).copied().unwrap_or(0);
    if let Some(Value::Object(entries)) = nth(&mut scene, to) {
        entries.insert(key.clone(), part.clone());
    }
    let text = scene.to_string();
    let size = text.len().min(out.len());
    out[..size].copy_from_slice(&text.as_bytes()[..size]);
    size
}

fn pick<'a, T>(list: &'a [T], dice: &mut Random) -> Option<&'a T> {
    (!list.is_empty()).then(|| &list[dice.below(list.len())])
}

/// How many nodes a tree has.
fn nodes(node: &Value) -> usize {
    1 + match node {
        Value::Array(elements) => elements.iter().map(nodes).sum::<usize>(),
        Value::Object(entries) => entries.values().map(nodes).sum(),
        _ => 0,
    }
}

/// The node of that number, in the order of the text.
fn nth(node: &mut Value, number: usize) -> Option<&mut Value> {
    fn descend<'a>(node: &'a mut Value, left: &mut usize) -> Option<&'a mut Value> {
        if *left == 0 {
            return Some(node);
        }
        *left -= 1;
        match node {
            Value::Array(elements) => elements
                .iter_mut()
                .find_map(|element| descend(element, left)),
            Value::Object(entries) => entries.values_mut().find_map(|value| descend(value, left)),
            _ => None,
        }
    }
    let mut left = number;
    descend(node, &mut left)
}

/// One change at one place.
fn change(scene: &mut Value, dice: &mut Random) {
    let count = nodes(scene);
    // Something that stands elsewhere in the scene: it is more often right than something made up.
    let elsewhere = nth(scene, dice.below(count)).expect("it is there").clone();
    let mut texts = Vec::new();
    collect(scene, &mut texts);
    let text = match dice.below(4) {
        0 => pick(&WORDS, dice).cloned().unwrap_or_default(),
        1 => odd::text(dice),
        _ => pick(&texts, dice).cloned().unwrap_or_default(),
    };
    let node = nth(scene, dice.below(count)).expect("it is there");
    match node {
        Value::Number(number) => {
            let old = number.as_f64().unwrap_or(0.0);
            *node = match dice.below(6) {
                0 => json!(NUMBERS[dice.below(NUMBERS.len())]),
                1 => json!(-old),
                2 => json!(old * (1.0 + dice.within(1.0) * 10_f64.powi(-(dice.below(16) as i32)))),
                3 => json!(old * 10_f64.powi(dice.below(40) as i32 - 20)),
                4 => json!(f64::from_bits(dice.next())),
                _ if elsewhere.is_number() => elsewhere,
                _ => json!(dice.within(400.0).round()),
            };
        }
        Value::String(_) => *node = text.into(),
        Value::Array(elements) => {
            let at = dice.below(elements.len() + 1);
            match dice.below(4) {
                0 if at < elements.len() => _ = elements.remove(at),
                1 if at < elements.len() => elements.swap(0, at),
                2 => elements.insert(at, text.into()),
                _ => {
                    let new = pick(elements, dice).cloned().unwrap_or(elsewhere);
                    elements.insert(at, new);
                }
            }
        }
        Value::Object(entries) => {
            let key = entries
                .keys()
                .nth(dice.below(entries.len().max(1)))
                .cloned();
            match (dice.below(5), key) {
                (0, Some(key)) => _ = entries.shift_remove(&key),
                // Under another name.
                (1, Some(key)) => {
                    let value = entries.shift_remove(&key).expect("it is there");
                    entries.insert(text, value);
                }
                // A second of the same kind.
                (2, Some(key)) => {
                    let value = entries[&key].clone();
                    entries.insert(text, value);
                }
                (3, Some(key)) => _ = entries.insert(key, elsewhere),
                _ => _ = entries.insert(text, elsewhere),
            }
        }
        Value::Bool(truth) => *truth = !*truth,
        Value::Null => *node = elsewhere,
    }
}
