"""The smallest part of a mechanism that still disagrees, and a script that shows it."""

import copy
import json
import re

from mechanisms.check import DisagreementError, check
from mechanisms.generate import settle
from mechanisms.oracle import layout

SCRIPT = '''"""Found by seed {seed}: {message}"""

import json
import sys

sys.path.insert(0, "tests")  # in the project's folder

from mechanisms.check import check

check(json.loads("""{data}"""), {front_ends}, {answers})
'''


def smaller(data):
    """All mechanisms that have something less: the largest parts first."""
    parents = {body["on"] for body in data["bodies"]}
    for k in reversed(range(len(data["bodies"]))):
        if k in parents or len(data["bodies"]) == 1:
            continue
        found = copy.deepcopy(data)
        found["bodies"].pop(k)
        found["q"], found["u"] = _without(data, k)
        for part in ("loads", "loops", "auxiliary"):
            found[part] = [_moved(item, k) for item in found[part] if k not in _bodies(item)]
        yield renumbered(found, k)
    for part in ("loops", "loads", "speeds", "auxiliary", "inputs", "named"):
        for k in reversed(range(len(data[part]))):
            yield data | {part: data[part][:k] + data[part][k + 1 :]}
    if data["units"] != [1.0, 1.0, 1.0]:
        yield data | {"units": [1.0, 1.0, 1.0]}
    for part in ("gravity", "u"):
        if any(data[part]):
            yield data | {part: [0.0] * len(data[part])}
    yield from _rounder(data, data)


def _rounder(data, part, *keys):
    """The same with one list of decimals rounded, or a tilt left out."""
    items = part.items() if isinstance(part, dict) else enumerate(part)
    for key, value in items:
        if key in ("q", "u", "units", "across", "named", "inputs", "fixed_inputs", "plane"):
            continue
        if isinstance(value, list) and value and all(isinstance(v, float) for v in value):
            for new in ([0.0] * len(value), [float(round(v)) for v in value]):
                if new != value and (any(new) or key in ("tilt", "at", "centre")):
                    found = copy.deepcopy(data)
                    place = found
                    for step in keys:
                        place = place[step]
                    place[key] = new
                    yield found
        elif isinstance(value, (dict, list)):
            yield from _rounder(data, value, *keys, key)


def _bodies(item):
    if isinstance(item, dict):
        own = [item["body"]] if "body" in item else []
        return own + [b for value in item.values() for b in _bodies(value)]
    return []


def _moved(item, k):
    """The same item after body k is gone."""
    if not isinstance(item, dict):
        return item
    return {
        key: value - (value > k) if key == "body" else _moved(value, k)
        for key, value in item.items()
    }


def _without(data, k):
    gone_q, gone_u = set(), set()
    for _, of_q, of_u in layout(data)[0][k]:
        gone_q |= set(range(of_q.start, of_q.stop))
        gone_u |= set(range(of_u.start, of_u.stop))
    q = [v for i, v in enumerate(data["q"]) if i not in gone_q]
    return q, [v for i, v in enumerate(data["u"]) if i not in gone_u]


def renumbered(data, k):
    """Bodies behind k hang on one less."""
    for body in data["bodies"]:
        body["on"] -= body["on"] > k
    return data


def _failure(data, front_ends, answers):
    """The settled mechanism, and what is wrong with it, or None."""
    data = copy.deepcopy(data)
    try:
        settle(data)
        check(data, front_ends, answers)
    except Exception as error:  # noqa: BLE001 (whatever was raised first is looked for)
        return data, kind_of(error)
    return data, None


def kind_of(error):
    """What tells a failure from others: the answer, or the exception's type and first words.

    Names and numbers differ from part to part of a mechanism, and so may what they are quoted in.
    """
    if isinstance(error, DisagreementError):
        return str(error).split(": ")[1].split("[")[0]
    head = re.split(r"[`\d:;{(\[]", str(error).strip().splitlines()[0] if str(error) else "")[0]
    return type(error), head.strip() or str(error)[1:40]


def shrunk(data, front_ends, answers, most=100):
    """The smallest mechanism found that fails in the same way."""
    _, wrong = _failure(data, front_ends, answers)
    left, found = most, data
    while wrong is not None and left > 0:
        for candidate in smaller(found):
            left -= 1
            settled, now = _failure(candidate, front_ends, answers)
            if now == wrong or left <= 0:
                break
        else:
            break
        found = settled if now == wrong else found
    return found


def script(data, front_ends, answers, error):
    text = json.dumps(data).replace("\\", "\\\\")
    message = str(error).replace('"""', "'''").splitlines()[0]
    return SCRIPT.format(
        seed=data["seed"], message=message, data=text, front_ends=front_ends, answers=answers
    )
