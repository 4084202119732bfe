//! Unknowns that follow others, as those of points beside a face that is held do.

/// Entries of vectors that are sums of others.
#[derive(Clone, Debug, Default)]
pub(super) struct Followers(Vec<Follower>);

#[derive(Clone, Debug)]
struct Follower {
    entry: u32,
    /// Entries that it follows, and their shares.
    leaders: Vec<(u32, f32)>,
}

impl Followers {
    pub(super) fn push(&mut self, entry: usize, leaders: impl Iterator<Item = (usize, f64)>) {
        let leaders = leaders.map(|(entry, share)| (entry as u32, share as f32)).collect();
        self.0.push(Follower { entry: entry as u32, leaders });
    }

    /// Entries that follow.
    pub(super) fn entries(&self) -> impl Iterator<Item = usize> + '_ {
        self.0.iter().map(|follower| follower.entry as usize)
    }

    /// Lets them follow.
    pub(super) fn follow(&self, v: &mut [f32]) {
        for Follower { entry, leaders } in &self.0 {
            v[*entry as usize] = leaders.iter().map(|(leader, share)| share * v[*leader as usize]).sum();
        }
    }

    /// Hands the forces on them to those that they follow.
    pub(super) fn hand_over(&self, force: &mut [f32]) {
        for Follower { entry, leaders } in &self.0 {
            let own = std::mem::take(&mut force[*entry as usize]);
            leaders.iter().for_each(|(leader, share)| force[*leader as usize] += share * own);
        }
    }

    /// Calls `take` with what is added to every entry that one follows, per share, where these entries changed from some values.
    pub(super) fn for_each_change(&self, v: &mut [f32], from: &[f32], take: impl Fn(&mut [f32], usize, f32)) {
        for (Follower { entry, leaders }, from) in self.0.iter().zip(from) {
            let change = v[*entry as usize] - from;
            leaders.iter().for_each(|(leader, share)| take(v, *leader as usize, share * change));
        }
    }
}
