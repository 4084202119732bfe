//! One step of elimination on the quotient graph.

use super::MinimumDegree;

impl MinimumDegree {
    /// Turns the pivot into an element; returns its weight. The weights of its variables are negative from here to `finish`.
    pub(super) fn gather(&mut self, pivot: u32) -> i32 {
        let p = pivot as usize;
        let weight = self.weight[p];
        self.weight[p] = 0;
        let (first, elements, begin) = (self.start[p], self.elements[p] as usize, self.lists.len());
        for k in 0..self.length[p] as usize {
            let node = self.lists[first + k];
            if k < elements {
                if std::mem::take(&mut self.live[node as usize]) {
                    for m in self.range(node) {
                        self.take(self.lists[m]);
                    }
                }
            } else {
                self.take(node);
            }
        }
        self.start[p] = begin;
        self.length[p] = (self.lists.len() - begin) as u32;
        self.live[p] = true;
        let sum: i32 = self.lists[begin..].iter().map(|v| -self.weight[*v as usize]).sum();
        self.degree[p] = sum as u32;
        weight
    }

    /// Adds a variable to the element at the end of the lists unless it is there, merged or eliminated.
    fn take(&mut self, variable: u32) {
        let weight = self.weight[variable as usize];
        if weight > 0 {
            self.weight[variable as usize] = -weight;
            self.lists.push(variable);
            if variable < self.inner {
                self.remove(variable);
            }
        }
    }

    /// For every other element that shares variables with the pivot's: the weight of what it does not share.
    pub(super) fn measure(&mut self, pivot: u32) {
        self.stamp += 1;
        for k in self.range(pivot) {
            let i = self.lists[k] as usize;
            for m in self.start[i]..self.start[i] + self.elements[i] as usize {
                let e = self.lists[m] as usize;
                if self.live[e] {
                    if self.mark[e] != self.stamp {
                        self.mark[e] = self.stamp;
                        self.outside[e] = self.degree[e];
                    }
                    self.outside[e] -= (-self.weight[i]) as u32;
                }
            }
        }
    }

    /// Removes what the pivot's element covers from the lists of its variables, bounds their degrees outside of it
    /// and eliminates those that have nothing outside; returns the weight of the latter.
    pub(super) fn shorten(&mut self, pivot: u32, emit: &mut impl FnMut(u32)) -> i32 {
        let mut eliminated = 0;
        self.hashed.clear();
        for k in self.range(pivot) {
            let variable = self.lists[k];
            let i = variable as usize;
            let (start, elements) = (self.start[i], self.elements[i] as usize);
            let (mut to, mut degree, mut hash) = (start, 0, 0_u64);
            for m in start..start + elements {
                let e = self.lists[m];
                if !self.live[e as usize] {
                    continue;
                }
                if self.outside[e as usize] == 0 {
                    self.live[e as usize] = false;
                    continue;
                }
                degree += self.outside[e as usize];
                hash += u64::from(e);
                self.lists[to] = e;
                to += 1;
            }
            let kept = to;
            for m in start + elements..start + self.length[i] as usize {
                let v = self.lists[m];
                if self.weight[v as usize] > 0 {
                    degree += self.weight[v as usize] as u32;
                    hash += u64::from(v);
                    self.lists[to] = v;
                    to += 1;
                }
            }
            if degree == 0 && variable < self.inner {
                eliminated -= self.weight[i];
                self.weight[i] = 0;
                self.emit_chain(variable, emit);
                continue;
            }
            // The pivot, or an element that it absorbed, has left a gap.
            self.lists[to] = self.lists[kept];
            self.lists[kept] = self.lists[start];
            self.lists[start] = pivot;
            self.elements[i] = (kept - start + 1) as u32;
            self.length[i] = (to - start + 1) as u32;
            self.degree[i] = self.degree[i].min(degree);
            self.hashed.push((hash, variable));
        }
        self.degree[pivot as usize] -= eliminated as u32;
        eliminated
    }

    /// Merges variables of the pivot's element that have the same lists.
    pub(super) fn merge(&mut self) {
        self.hashed.sort_unstable();
        for a in 0..self.hashed.len() {
            let (hash, variable) = self.hashed[a];
            let i = variable as usize;
            if self.weight[i] == 0 {
                continue;
            }
            let mut marked = false;
            for b in a + 1..self.hashed.len() {
                let (other_hash, other) = self.hashed[b];
                if other_hash != hash {
                    break;
                }
                let j = other as usize;
                let alike = self.length[i] == self.length[j]
                    && self.elements[i] == self.elements[j]
                    && (variable < self.inner) == (other < self.inner);
                if self.weight[j] == 0 || !alike {
                    continue;
                }
                if !marked {
                    marked = true;
                    self.stamp += 1;
                    for m in self.range(variable) {
                        self.mark[self.lists[m] as usize] = self.stamp;
                    }
                }
                if self.range(other).all(|m| self.mark[self.lists[m] as usize] == self.stamp) {
                    self.weight[i] += std::mem::take(&mut self.weight[j]);
                    self.chain[self.tail[i] as usize] = other;
                    self.tail[i] = self.tail[j];
                }
            }
        }
    }

    /// Drops what is merged or eliminated from the pivot's element, makes the weights positive again and files the
    /// variables under their new degrees; returns the lowest of these.
    pub(super) fn finish(&mut self, pivot: u32) -> usize {
        let (p, mut lowest) = (pivot as usize, usize::MAX);
        let mut to = self.start[p];
        for k in self.range(pivot) {
            let variable = self.lists[k];
            let i = variable as usize;
            if self.weight[i] == 0 {
                continue;
            }
            self.weight[i] = -self.weight[i];
            self.lists[to] = variable;
            to += 1;
            if variable < self.inner {
                self.degree[i] += self.degree[p] - self.weight[i] as u32;
                self.degree[i] = self.degree[i].min(self.head.len() as u32 - 1);
                self.insert(variable);
                lowest = lowest.min(self.degree[i] as usize);
            }
        }
        self.length[p] = (to - self.start[p]) as u32;
        self.lists.truncate(to);
        lowest
    }
}
