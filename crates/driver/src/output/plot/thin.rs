//! Fewer points that look the same.

/// At most `most` points (4 or more) that look like all: of each bin the lowest and the highest, in their
/// order, and both ends.
pub(crate) fn thin(points: &[(f64, f64)], most: usize) -> Vec<(f64, f64)> {
    if points.len() <= most {
        return points.to_vec();
    }
    let (first, inner, last) = (points[0], &points[1..points.len() - 1], points[points.len() - 1]);
    let bin = inner.len().div_ceil((most - 2) / 2);
    let mut kept = vec![first];
    for bin in inner.chunks(bin) {
        let by_y = |&a: &usize, &b: &usize| bin[a].1.total_cmp(&bin[b].1);
        let lowest = (0..bin.len()).min_by(by_y).unwrap_or(0);
        let highest = (0..bin.len()).max_by(by_y).unwrap_or(0);
        kept.push(bin[lowest.min(highest)]);
        if lowest != highest {
            kept.push(bin[lowest.max(highest)]);
        }
    }
    kept.push(last);
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn extremes_ends_and_order_are_kept() {
        let mut points: Vec<_> = (0..100_000).map(|i| (f64::from(i), f64::from(i % 977).sin())).collect();
        points[12_345].1 = 7.0;
        points[65_432].1 = -9.0;
        let kept = thin(&points, 2000);
        assert!((1000..=2000).contains(&kept.len()), "{}", kept.len());
        assert!(kept.contains(&points[12_345]) && kept.contains(&points[65_432]));
        assert_eq!((kept[0], kept[kept.len() - 1]), (points[0], points[99_999]));
        assert!(kept.is_sorted_by(|a, b| a.0 < b.0));
    }

    #[test]
    fn few_points_are_left_alone_and_the_limit_holds() {
        let points: Vec<_> = (0..2003).map(|i| (f64::from(i), f64::from(i * i % 71))).collect();
        assert_eq!(thin(&points[..2000], 2000), points[..2000]);
        for most in [4, 5, 100, 1999, 2000, 2002] {
            assert!(thin(&points, most).len() <= most, "{most}");
        }
    }
}
