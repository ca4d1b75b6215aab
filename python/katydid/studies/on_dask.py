"""Workers of a Dask cluster: processes that keep the prepared definition."""

import logging
import time

from . import recipe as recipes
from .schedule import Lost

#: How often the size of the cluster is asked for.
LOOK = 1.0


def _distributed():
    try:
        import distributed
    except ImportError as error:
        from .._katydid import NotSupportedError
        raise NotSupportedError('the engine "dask" needs the package distributed: pip install "katydid[dask]"') from error
    return distributed


class DaskPool:
    """A batch for each thread of the cluster's workers, however many come and go.

    `address` is that of the scheduler, a `distributed.Client`, or None or "local" for processes on this machine, `workers` of
    them, which end with the study. Dask gives a batch to another worker when one ends; after some times (its setting
    `distributed.scheduler.allowed-failures`) the batch is lost.
    """

    def __init__(self, recipe, workers=None, address=None):
        self.distributed = _distributed()
        self.cluster = None
        self.owns = not isinstance(address, self.distributed.Client)
        self.most = None
        if address in (None, "local"):
            self.cluster = self.distributed.LocalCluster(
                n_workers=workers, threads_per_worker=1, dashboard_address=None, silence_logs=logging.ERROR)
            self.client = self.distributed.Client(self.cluster)
        elif self.owns:
            self.client = self._reach(address)
            self.most = workers
        else:
            self.client, self.most = address, workers
        self.recipe = self.client.scatter(recipe, broadcast=True)
        self.running = {}
        self.looked = None
        self.threads = 0

    def _reach(self, address):
        try:
            return self.distributed.Client(address)
        except OSError as error:
            from .._katydid import KatydidError
            raise KatydidError("the Dask scheduler %s cannot be reached: %s" % (address, error)) from error

    def workers(self):
        """How many batches are solved side by side."""
        now = time.monotonic()
        if self.looked is None or now - self.looked > LOOK:
            self.looked = now
            self.threads = sum(self.client.nthreads().values())
        return self.threads if self.most is None else min(self.most, self.threads)

    def room(self):
        """How many batches may be begun: one for each thread."""
        return self.workers() - len(self.running)

    def begin(self, points):
        """Hands a batch over."""
        future = self.client.submit(recipes.solve, self.recipe, points, pure=False)
        self.running[future.key] = future
        return future.key

    def wait(self, seconds):
        """What came back."""
        if not self.running:
            time.sleep(min(seconds, LOOK))
            return []
        try:
            self.distributed.wait(list(self.running.values()), timeout=seconds, return_when="FIRST_COMPLETED")
        except (TimeoutError, self.distributed.TimeoutError):
            return []
        done = [key for key, future in self.running.items() if future.done()]
        return [(key, self._result(self.running.pop(key))) for key in done]

    def _result(self, future):
        from .._katydid import KatydidError
        try:
            return future.result()
        except self.distributed.scheduler.KilledWorker as error:
            return Lost("KilledWorker: %s" % error.last_worker)
        except KatydidError:
            raise
        except Exception as error:
            # A future that was cancelled lost its worker or its input.
            if future.cancelled():
                return Lost(str(error))
            raise

    def end(self, key):
        """Ends the process that has a batch."""
        future = self.running.pop(key)
        busy = [worker for worker, keys in self.client.processing().items() if key in keys]
        future.cancel()
        self.client.restart_workers(busy, raise_for_error=False)

    def close(self):
        """Lets go of the cluster, and ends it where it was started for the study."""
        for future in self.running.values():
            future.cancel()
        self.recipe = None
        if self.owns:
            self.client.close()
        if self.cluster is not None:
            self.cluster.close()
