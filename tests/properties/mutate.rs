//! Random changes of JSON values. The fuzzer of `fuzz` includes this file, too.

use serde_json::{Map, Value, json};

/// Numbers without a pattern (SplitMix64).
pub(crate) struct Random(pub(crate) u64);

impl Random {
    /// A number below `end`, which is above zero.
    pub(crate) fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) % end as u64) as usize
    }

    /// One of several.
    pub(crate) fn pick<'a, T>(&mut self, all: &'a [T]) -> &'a T {
        &all[self.below(all.len())]
    }
}

/// Removes, repeats or replaces a value somewhere; others come from `donor`, from where it has them by the same key.
pub(crate) fn mutate(value: &mut Value, donor: &Value, random: &mut Random) {
    let children = match value {
        Value::Object(map) => map.len(),
        Value::Array(list) => list.len(),
        _ => 0,
    };
    if children == 0 || random.below(12) == 0 {
        *value = replaced(value, random);
        return;
    }
    let k = random.below(children);
    match value {
        Value::Object(map) => mutate_member(map, k, donor, random),
        Value::Array(list) => match random.below(12) {
            0 => drop(list.remove(k)),
            1 => list.push(list[k].clone()),
            2 => list.swap(0, k),
            _ => mutate(&mut list[k], donor, random),
        },
        _ => {}
    }
}

fn mutate_member(map: &mut Map<String, Value>, k: usize, donor: &Value, random: &mut Random) {
    let Some(key) = map.keys().nth(k).cloned() else { return };
    match random.below(12) {
        0 => drop(map.shift_remove(&key)),
        1 | 2 => {
            let mut found = Vec::new();
            collect(donor, &key, &mut found);
            if !found.is_empty() {
                map.insert(key, (*random.pick(&found)).clone());
            }
        }
        // A key of another object: a load of another kind, a support of other keys.
        3 => {
            let mut found = Vec::new();
            siblings(donor, &key, &mut found);
            if !found.is_empty() {
                let (other, inner) = *random.pick(&found);
                map.insert(other.clone(), inner.clone());
            }
        }
        _ => map.values_mut().nth(k).into_iter().for_each(|inner| mutate(inner, donor, random)),
    }
}

/// Values of a key anywhere in a value.
fn collect<'a>(value: &'a Value, key: &str, found: &mut Vec<&'a Value>) {
    match value {
        Value::Object(map) => {
            found.extend(map.get(key));
            map.values().for_each(|inner| collect(inner, key, found));
        }
        Value::Array(list) => list.iter().for_each(|inner| collect(inner, key, found)),
        _ => {}
    }
}

/// What stands beside a key anywhere in a value.
fn siblings<'a>(value: &'a Value, key: &str, found: &mut Vec<(&'a String, &'a Value)>) {
    match value {
        Value::Object(map) => {
            if map.contains_key(key) {
                found.extend(map.iter().filter(|(other, _)| *other != key));
            }
            map.values().for_each(|inner| siblings(inner, key, found));
        }
        Value::Array(list) => list.iter().for_each(|inner| siblings(inner, key, found)),
        _ => {}
    }
}

fn replaced(value: &Value, random: &mut Random) -> Value {
    const EXTREME: [f64; 14] =
        [0.0, -1.0, 0.5, 1.0, 2.0, 3.0, 1e-300, -1e300, 1e308, 5e-324, 1e9, 1e-9, 1e15, 4_294_967_296.0];
    const FACTORS: [f64; 8] = [-1.0, 0.5, 2.0, 1.000_000_1, 10.0, 0.1, 1e6, 1e-6];
    match (value.as_f64(), random.below(8)) {
        (Some(number), 0..=3) => {
            let number = number * random.pick(&FACTORS);
            if value.is_u64() && number >= 0.0 { json!(number as u64) } else { json!(number) }
        }
        (Some(_), 4 | 5) => json!(random.pick(&EXTREME)),
        (Some(_), 6) => json!(random.below(1000)),
        (Some(_), 7) if value.is_u64() => json!(u64::MAX >> random.below(64)),
        (_, 0) => json!([]),
        (_, 1) => json!({}),
        (_, 2) => json!([0.0, 1.0]),
        (_, 3) => json!(null),
        (_, 4) => json!("x"),
        (_, 5) => json!(true),
        _ => json!(random.below(100)),
    }
}
