"""A million bicycles with constraints and events: on two cores, and on a Dask cluster."""

from __future__ import annotations

import argparse
from typing import Any

from harness.bicycles import TIMES, Costs
from harness.driver import Worker
from harness.options import add_pythons
from harness.report import save

ALLOWED = 1.1  # times the processor time of lanes on one thread


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    add_pythons(parser, "--python")
    parser.add_argument("--counts", type=int, nargs="+", default=[10_000, 100_000, 1_000_000])
    parser.add_argument("--alone", type=int, default=32_768, help="trajectories on one thread")
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--processes", type=int, default=4)
    parser.add_argument("--block", type=int, help="trajectories of a Dask task")
    parser.add_argument("--blocks", type=int, nargs=2, default=[2500, 125], help="for the costs")
    parser.add_argument("--cores", type=int, nargs="+", default=[4, 16, 100, 400])
    parser.add_argument("--quick", action="store_true", help="few trajectories, to try the script")
    options = parser.parse_args()
    if options.quick:
        options.counts, options.alone, options.blocks = [400, 800], 256, [200, 50]
    print(f"Bicycles, {TIMES[-1]:g} s, projected, two events, dop853 at rtol 1e-6\n")
    # Processors' speed varies while this runs: the base is measured before and after the others.
    before = _ask(options, "lanes", count=options.alone)
    ways = {
        f"{options.threads} threads, store": ("threads", {"threads": options.threads}),
        f"Dask, {options.processes} workers": (
            "cluster",
            {"processes": options.processes, "block": options.block},
        ),
    }
    answers = [
        (name, count, _ask(options, do, count=count, **how))
        for count in options.counts
        for name, (do, how) in ways.items()
    ]
    after = _ask(options, "lanes", count=options.alone)
    base = (before["own"] + after["own"]) / (2 * options.alone)
    print("| way | trajectories | seconds | processor µs each | over one thread | GiB | a worker |")
    print("|---|---|---|---|---|---|---|")
    single = [
        _line(name, options.alone, answer, base)
        for name, answer in (("one thread, before", before), ("after", after))
    ]
    lines = [_line(*answer, base) for answer in answers]
    _check_equal(lines, options.counts)
    carried = _carried(options, lines[-1])
    save("many_bicycles", {"one thread": single, "lines": lines, **carried})


def _ask(options: argparse.Namespace, do: str, **arguments: Any) -> dict[str, Any]:
    """Return what a way took in a process of its own, whose memory is that of this way alone."""
    with Worker("many-bicycles", options.python, "bicycles_ours.py", timeout=3600.0) as worker:
        worker.ask("load")
        answer: dict[str, Any] = worker.ask(do, **arguments)
        return answer


def _line(name: str, count: int, answer: dict[str, Any], base: float) -> dict[str, Any]:
    """Print and return a row of the table."""
    each = (answer["own"] + answer["workers"]) / count
    ratio = each / base
    worker = f"{answer['workers_GiB']:.2f}" if "workers_GiB" in answer else "–"
    cells = [
        name,
        f"{count:,}",
        f"{answer['seconds']:.1f}",
        f"{1e6 * each:.1f}",
        f"{ratio:.2f}" + ("" if ratio <= ALLOWED else f" (more than {ALLOWED})"),
        f"{answer['GiB']:.2f}",
        worker,
    ]
    print(f"| {' | '.join(cells)} |", flush=True)
    return answer | {"way": name, "count": count, "each": each, "ratio": ratio}


def _check_equal(lines: list[dict[str, Any]], counts: list[int]) -> None:
    """Raise an error if two ways count differently: each sample is the same bits in all."""
    for count in counts:
        sums = [line["sums"] for line in lines if line["count"] == count]
        for name in ("finished", "fallen", "upright", "most_offset"):
            values = {each[name] for each in sums}
            if len(values) > 1:
                raise RuntimeError(f"`{name}` of {count:,} bicycles is {values}")
    last = lines[-1]["sums"]
    print(
        f"\n{last['finished']:,.0f} rode to the end, {last['fallen']:,.0f} fell; upright "
        f"{last['upright']:,.0f} times; largest lean to the right {last['mean_lean']:.3f} rad "
        f"in the mean; "
        f"{last['steps']:.1f} steps."
    )


def _carried(options: argparse.Namespace, largest: dict[str, Any]) -> dict[str, Any]:
    """Measure the costs of a cluster, and print how far it carries by them."""
    count, (block, fine) = options.counts[0], options.blocks
    with Worker("many-bicycles", options.python, "bicycles_ours.py", timeout=3600.0) as worker:
        worker.ask("load")
        asked = {"count": count, "processes": options.processes, "blocks": [block, fine]}
        finer, coarse = worker.ask("costs", **asked)
    more = finer["blocks"] - coarse["blocks"]

    def of_block(cost: str) -> float:
        return max(0.0, finer[cost] - coarse[cost]) / more

    own, task, blocks = of_block("own"), of_block("workers"), largest["blocks"]
    costs = Costs(
        trajectory=(largest["workers"] - task * blocks) / largest["count"],
        serial=max(0.0, largest["own"] - own * blocks) / largest["count"],
        block=own,
        task=task,
        start=largest["start"],
    )
    million = largest["count"]
    print(
        f"\nA trajectory takes {1e6 * costs.trajectory:.1f} µs on a worker and "
        f"{1e6 * costs.serial:.2f} µs on client and scheduler, where it sends "
        f"{largest['sent']:.0f} bytes; a block {1e3 * costs.block:.1f} ms there and "
        f"{1e3 * costs.task:.1f} ms on a worker; a worker {costs.start:.2f} s to start, and "
        f"{100 * largest['idle'] / options.processes:.1f} % of a core for its own "
        f"(the scheduler {100 * largest['scheduler']:.1f} %).\n"
        "T = start + N serial + blocks overhead + ⌈blocks / cores⌉ (block trajectory + task), "
        f"N = {million:,}:\n"
    )
    sizes = [size for size in (8192, 2048, 512, 128) if size <= million]
    print(f"| cores | {' | '.join(f'blocks of {size:,}' for size in sizes)} |")
    print(f"|---|{'---|' * len(sizes)}")
    most = " | ".join(f"{costs.most_cores(size):.0f}" for size in sizes)
    print(f"| the scheduler keeps busy | {most} |")
    table = {}
    for cores in options.cores:
        seconds = [costs.seconds(million, size, cores) for size in sizes]
        shares = [costs.efficiency(million, size, cores) for size in sizes]
        pairs = zip(seconds, shares, strict=True)
        print(f"| {cores} | {' | '.join(f'{t:.1f} s, {100 * e:.0f} %' for t, e in pairs)} |")
        table[cores] = dict(zip(map(str, sizes), shares, strict=True))
    return {"costs": vars(costs), "runs": [finer, coarse], "efficiency": table}


if __name__ == "__main__":
    main()
