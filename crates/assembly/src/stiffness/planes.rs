//! Vectors in component planes, dealt out in parts of consecutive points.

use rayon::prelude::*;
use std::array::from_fn;

/// Points below which threads cost more than they bring.
const FEW: usize = 8192;
/// Points that one thread takes at a time.
const PART: usize = 4096;

/// The planes of a vector.
pub(crate) fn planes<const D: usize, R>(u: &[R]) -> [&[R]; D] {
    let n = u.len() / D;
    from_fn(|c| &u[c * n..][..n])
}

/// The planes of a vector to be written.
pub(crate) fn planes_mut<const D: usize, R>(u: &mut [R]) -> [&mut [R]; D] {
    let n = (u.len() / D).max(1);
    let mut planes = u.chunks_exact_mut(n);
    from_fn(|_| planes.next().unwrap_or_default())
}

/// The first `count` entries of every plane; the rest stays.
pub(crate) fn take_front<'a, const D: usize, R>(
    rest: &mut [&'a mut [R]; D],
    count: usize,
) -> [&'a mut [R]; D] {
    rest.each_mut().map(|rest| rest.split_off_mut(..count).unwrap_or_default())
}

/// Calls `work` with stretches of at most `stretch` points: the number of the first and the planes of `out` there.
pub(crate) fn for_each_stretch<const D: usize, R: Send>(
    out: &mut [R],
    stretch: usize,
    work: impl Fn(usize, [&mut [R]; D]) + Sync,
) {
    let n = out.len() / D;
    let mut rest = planes_mut::<D, R>(out);
    let parts: Vec<(usize, [&mut [R]; D])> =
        (0..n).step_by(PART).map(|first| (first, take_front(&mut rest, PART.min(n - first)))).collect();
    let part = |(first, mut own): (usize, [&mut [R]; D])| {
        let count = own[0].len();
        for from in (0..count).step_by(stretch) {
            work(first + from, take_front(&mut own, stretch.min(count - from)));
        }
    };
    match n < FEW {
        true => parts.into_iter().for_each(part),
        false => parts.into_par_iter().for_each(part),
    }
}
