"""Check seeds: ``python tests/mechanisms/run.py 0:600 [JOBS]``, or one seed, with all answers.

Each seed is a mechanism and a block in contact.

What disagrees is shrunk and printed as a script. The last lines tell the largest ratios to what is
allowed.
"""

import multiprocessing
import sys
import warnings
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from mechanisms import contacts
from mechanisms.check import check, turn_of
from mechanisms.generate import draw
from mechanisms.shrink import script, shrunk


def checked(seed, everything=False):
    """The worst ratios of a seed, and what to print if it fails."""
    warnings.simplefilter("error")  # right results never warn
    data = draw(seed)
    front_ends, answers = (None, ()) if everything else turn_of(seed)
    try:
        ratios = check(data, front_ends, answers)
    except Exception as error:  # noqa: BLE001 (a failure of any kind is shrunk and shown)
        least = shrunk(data, front_ends, answers)
        return seed, {}, script(least, front_ends, answers, error)
    block = contacts.draw(seed)
    try:
        return seed, {**ratios, "contact": contacts.check(block)}, None
    except Exception as error:  # noqa: BLE001
        return seed, ratios, contacts.script(contacts.shrunk(block), error)


def main(seeds, jobs=1):
    first, _, last = seeds.partition(":")
    worst, failed = {}, []
    everything = not last
    numbers = range(int(first), int(last or int(first) + 1))
    with multiprocessing.get_context("spawn").Pool(int(jobs), maxtasksperchild=50) as pool:
        todo = ((seed, everything) for seed in numbers)
        for seed, ratios, text in pool.imap_unordered(_starred, todo):
            if text is not None:
                failed.append(seed)
                sys.stdout.write(f"{text}\n")
                sys.stdout.flush()
            for name, ratio in ratios.items():
                if ratio > worst.get(name, (0.0, 0))[0]:
                    worst[name] = ratio, seed
    for name, (ratio, seed) in worst.items():
        sys.stdout.write(f"{name:24} {ratio:.1e} of what is allowed, seed {seed}\n")
    sys.stdout.write(f"{len(numbers)} mechanisms, {len(failed)} disagree: {sorted(failed)}\n")
    return bool(failed)


def _starred(arguments):
    return checked(*arguments)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
