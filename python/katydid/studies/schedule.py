"""Points in batches on the workers of any engine: batches again when a worker ends, points given up that end it each time.

An engine's pool has `room()`, how many batches may be begun now; `begin(points)`, which gives a handle; `wait(seconds)`, which
gives pairs of a handle and `(records, files, seconds)` or `Lost`; and `end(handle)`, which ends the worker that has a batch.
"""

import collections
import time

#: How long a batch should take: long beside what handing it over costs, short beside the study.
SECONDS = 0.5
#: The most points of a batch: their results are held in memory.
MOST = 4096
#: How often a worker may end with a single point before the point is given up.
ATTEMPTS = 3
#: How long no answer is waited for beyond the time that points have: to start a process, and to move files.
GRACE = 30.0


class Lost:
    """The worker that had a batch ended, and why."""

    def __init__(self, why):
        self.why = why


class _Task:
    def __init__(self, points, attempts=0):
        self.points = points
        self.attempts = attempts
        self.begun = 0.0


class Schedule:
    """Solves what `take(most)` gives, a list of points, until that is empty.

    `keep(records, files)` takes results, `give_up(point, why, seconds)` points that cannot be solved. `left()` says how many
    points may still come, or None. `limit` is how many seconds a point may take by the study's own limit.
    """

    def __init__(self, pool, take, keep, give_up, *, left=lambda: None, limit=None, grace=GRACE, told=lambda: None):
        self.pool, self.take, self.keep, self.give_up = pool, take, keep, give_up
        self.left, self.limit, self.grace, self.told = left, limit, grace, told
        self.again = collections.deque()
        self.running = {}
        self.size = 1
        self.each = None
        self.is_over = False

    def run(self):
        """Until all points are solved or given up."""
        while True:
            while self.pool.room() > 0:
                task = self._next()
                if task is None:
                    break
                task.begun = time.monotonic()
                self.running[self.pool.begin(task.points)] = task
            if not self.running and self.is_over and not self.again:
                return
            for handle, result in self.pool.wait(0.2):
                task = self.running.pop(handle, None)
                if task is not None:
                    self._came(task, result)
            self._end_what_hangs()

    def _next(self):
        if self.again:
            return self.again.popleft()
        if self.is_over:
            return None
        points = self.take(self._batch())
        self.is_over = not points
        return _Task(points) if points else None

    def _batch(self):
        """How many points the next batch has: fewer towards the end, so that no worker waits for another."""
        left = self.left()
        if left is None:
            return self.size
        return max(1, min(self.size, -(-left // (2 * max(1, self.pool.workers())))))

    def _came(self, task, result):
        if isinstance(result, Lost):
            self._lost(task, result.why)
            return
        records, files, seconds = result
        self.keep(records, files)
        each = seconds / len(task.points)
        self.each = each if self.each is None else 0.7 * self.each + 0.3 * each
        wanted = int(SECONDS / max(self.each, 1e-9))
        self.size = max(1, min(wanted, 8 * self.size, MOST))
        self.told()

    def _lost(self, task, why):
        """A batch is halved until the point is alone that ends its worker."""
        points = task.points
        if len(points) > 1:
            half = len(points) // 2
            self.again.extend((_Task(points[:half]), _Task(points[half:])))
            return
        task.attempts += 1
        if task.attempts < ATTEMPTS:
            self.again.append(task)
            return
        self.give_up(points[0], "its worker ended %d times: %s" % (task.attempts, why), time.monotonic() - task.begun)
        self.told()

    def _end_what_hangs(self):
        if self.limit is None:
            return
        now = time.monotonic()
        for handle, task in list(self.running.items()):
            expected = 10 * (self.each or 0.0) * len(task.points)
            if now - task.begun > 1.5 * self.limit + self.grace + expected:
                del self.running[handle]
                self.pool.end(handle)
                self._lost(task, "it gave no answer for %.0f s" % (now - task.begun))
