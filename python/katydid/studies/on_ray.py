"""Workers on a Ray cluster: actors that hold the prepared definition."""

import os
import socket
import time

from .recipe import PointWorker
from .schedule import Lost

#: How often the size of the cluster is asked for.
LOOK = 2.0
#: How long a cluster's address may take to answer.
REACH = 10.0
#: How long an actor that ended is left alone before it is asked again whether it is there.
PAUSE = 0.5
#: More bytes than this go to the machines once, through Ray's store, and not with each actor.
SMALL = 1 << 16


def _ray():
    try:
        import ray
    except ImportError as error:
        from .._katydid import NotSupportedError
        raise NotSupportedError('the engine "ray" needs the package ray: pip install "katydid[ray]"') from error
    return ray


def _reach(address):
    """An error where nobody listens at `host:port`: Ray itself would try for minutes, and heed no signal meanwhile."""
    host, _, port = str(address or "").rpartition("//")[2].rpartition(":")
    if host and port.isdigit():
        socket.create_connection((host, int(port)), timeout=REACH).close()


class RayPool:
    """An actor for each processor of the cluster, or as many as `workers` says: a number, or the least and the most.

    Ray starts actors again that ended, on another machine where theirs is gone, and has its autoscaler start machines for those
    that find no room. New machines get actors as they come. `address` is that of the cluster, "auto" or None for the one that
    this process belongs to, or "local" for one that is started here and ends with the study. `options` are those of the actors,
    as `ray.remote` takes them.
    """

    def __init__(self, recipe, workers=None, address=None, options=None):
        ray = self.ray = _ray()
        self.owns = not ray.is_initialized()
        if self.owns:
            # Without this the start of Ray would report the use of it.
            os.environ.setdefault("RAY_USAGE_STATS_ENABLED", "0")
            self._start(address, workers)
        self.least, self.most = workers if isinstance(workers, tuple) else (workers or 0, workers)
        self.recipe = recipe if recipe.size < SMALL else ray.put(recipe)
        options = {"num_cpus": 1, **(options or {}), "max_restarts": -1, "max_task_retries": 0}
        self.actor = ray.remote(**options)(PointWorker)
        self.cpus = options["num_cpus"] or 1
        #: What each call is for: an actor that gets ready, or one that solves.
        self.starting = {}
        self.solving = {}
        self.idle = []
        #: Actors that Ray starts again, and when they are asked.
        self.restarting = []
        self.count = 0
        self.looked = 0.0
        self._grow()

    def _start(self, address, workers):
        quiet = {"log_to_driver": False, "logging_level": "warning"}
        if address == "local":
            most = workers[1] if isinstance(workers, tuple) else workers
            self.ray.init(address="local", num_cpus=most, include_dashboard=False, **quiet)
            return
        try:
            _reach(address)
            self.ray.init(address=address or "auto", **quiet)
        except (OSError, RuntimeError, ValueError) as error:
            from .._katydid import KatydidError
            raise KatydidError("the Ray cluster %s cannot be reached: %s" % (address or "auto", error)) from error

    def _grow(self):
        """Starts actors as far as the cluster has processors, and the least number in any case."""
        if time.monotonic() - self.looked < LOOK and self.count:
            return
        self.looked = time.monotonic()
        fitting = int(self.ray.cluster_resources().get("CPU", 0) // self.cpus)
        wanted = max(self.least, fitting if self.most is None else min(self.most, fitting), 1)
        while self.count < wanted:
            self.count += 1
            self._await(self.actor.remote(self.recipe))

    def _await(self, actor):
        self.starting[actor.ready.remote()] = actor

    def _later(self, actor):
        self.restarting.append((time.monotonic() + PAUSE, actor))

    def workers(self):
        """How many actors there are, or soon will be."""
        return self.count

    def room(self):
        """How many actors have nothing to do. An actor has one batch at a time, so that Ray's queues stay short."""
        self._grow()
        return len(self.idle)

    def begin(self, points):
        """Hands a batch to an actor."""
        actor = self.idle.pop()
        call = actor.solve.remote(points)
        self.solving[call] = actor
        return call

    def wait(self, seconds):
        """What came back. `ray.util.ActorPool` would do the same, but for an actor that ended does not tell with which batch."""
        now = time.monotonic()
        for pair in [pair for pair in self.restarting if pair[0] <= now]:
            self.restarting.remove(pair)
            self._await(pair[1])
        if self.restarting:
            seconds = min(seconds, PAUSE)
        calls = list(self.solving) + list(self.starting)
        if not calls:
            time.sleep(seconds)
            return []
        done, _ = self.ray.wait(calls, num_returns=len(calls), timeout=0)
        if not done:
            done, _ = self.ray.wait(calls, num_returns=1, timeout=seconds)
        return [pair for call in done for pair in self._came(call)]

    def _came(self, call):
        errors = self.ray.exceptions
        if call in self.starting:
            actor = self.starting.pop(call)
            try:
                self.ray.get(call)
                self.idle.append(actor)
            except errors.ActorUnavailableError:
                self._later(actor)
            except errors.RayActorError as error:
                if getattr(error, "actor_init_failed", True):
                    self._failed(error)
                self._later(actor)
            return []
        actor = self.solving.pop(call)
        try:
            result = self.ray.get(call)
        except (errors.RayActorError, errors.RaySystemError, errors.ObjectLostError) as error:
            self._later(actor)
            return [(call, Lost(_first_line(error)))]
        except errors.RayTaskError as error:
            self._failed(error)
        self.idle.append(actor)
        return [(call, result)]

    def _failed(self, error):
        """What goes wrong in our own code goes wrong for every batch: the study ends with it."""
        from .._katydid import KatydidError
        lines = [line for line in str(error).strip().splitlines() if line.strip()]
        said = [line for line in lines if "Error: " in line] or lines or [type(error).__name__]
        raise KatydidError("a worker: " + said[-1].strip()) from error

    def end(self, call):
        """Ends the process of the actor that has a batch; Ray starts it again."""
        actor = self.solving.pop(call, None)
        if actor is not None:
            self.ray.kill(actor, no_restart=False)
            self._later(actor)

    def close(self):
        """Ends the actors, and Ray where it was started for the study."""
        restarting = [actor for _, actor in self.restarting]
        for actor in self.idle + restarting + list(self.starting.values()) + list(self.solving.values()):
            self.ray.kill(actor)
        self.idle, self.restarting, self.starting, self.solving = [], [], {}, {}
        if self.owns:
            self.ray.shutdown()


def _first_line(error):
    lines = str(error).strip().splitlines()
    return lines[0].strip() if lines else type(error).__name__
