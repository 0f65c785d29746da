"""Where tasks run. Each runner yields (path, result) as they come."""
import concurrent.futures as futures
import multiprocessing
from concurrent.futures.process import BrokenProcessPool
from typing import Any, Callable, Iterator, List, Tuple

from .task import Result, prepare_file

Done = Iterator[Tuple[str, Result]]
Work = Callable[[str], Result]
_IN_FLIGHT = 2  # files a process has waiting, so that none runs dry


def _lost(text: str) -> Result:
    return Result({"error": "WorkerLost", "text": text}, None)


def _pool(jobs: int) -> futures.ProcessPoolExecutor:
    return futures.ProcessPoolExecutor(jobs, multiprocessing.get_context("spawn"))


def run_here(paths: List[str], jobs: int, work: Work = prepare_file) -> Done:
    """In processes of this machine. A file that ends its process is named, and the others go on."""
    waiting, suspects = list(reversed(paths)), []
    while waiting:
        running = {}
        with _pool(jobs) as pool:
            try:
                while waiting or running:
                    while waiting and len(running) < jobs * _IN_FLIGHT:
                        path = waiting.pop()
                        running[path] = pool.submit(work, path)
                    futures.wait(running.values(), return_when=futures.FIRST_COMPLETED)
                    for path in [path for path, future in running.items() if future.done()]:
                        yield path, running[path].result()
                        del running[path]
            except BrokenProcessPool:
                suspects += running
    for path in suspects:  # one at a time, so that the guilty one is known
        with _pool(1) as pool:
            try:
                yield path, pool.submit(work, path).result()
            except BrokenProcessPool:
                yield path, _lost("its process has died")


def run_on_cluster(paths: List[str], address: str, work: Work = prepare_file) -> Done:
    """On the workers of a Dask scheduler, which read the files under the same paths. Tasks of a worker that dies are
    run by another."""
    import dask.distributed as dask  # pylint: disable=import-outside-toplevel

    with dask.Client(address) as client:
        tasks: Any = {client.submit(work, path, pure=False): path for path in paths}
        for task in dask.as_completed(tasks):
            if task.status == "error":
                yield tasks[task], _lost(f"{type(task.exception()).__name__}: {task.exception()}")
            else:
                yield tasks[task], Result(*task.result())
            task.release()
