"""Exports of a System: code for other programs."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from pydy._checks import file_of, flag, listed, text
from pydy._optional import progress_of
from pydy._simulation.exporting import exported_model
from pydy._system.setup import Setup

if TYPE_CHECKING:
    from pydy.export import Exported


class Exporting(Setup):
    """The system as code for other programs and for a page."""

    def export(
        self,
        path: Any,
        *,
        name: str | None = None,
        events: Any = None,
        inputs: Iterable[Any] = (),
        progress: bool = False,
        **options: Any,
    ) -> Exported:
        """Write the system as code for another program: C, an FMU, JavaScript or Python.

        Parameters
        ----------
        path : path
            The suffix selects the format: ``.c`` (C99, with a header next to it), ``.fmu`` (a
            functional mock-up unit for Model Exchange and Co-Simulation), ``.js`` (an ECMAScript
            module) or ``.py`` (functions that need only NumPy, JAX or CasADi).
        name : str, optional
            Name of the model; by default the stem of the file.
        events : Event or sequence of Event, optional
            Events to export with their resets; event indicators in an FMU.
        inputs : iterable of specifieds, optional
            Specifieds given by a function or by samples that become inputs.
        progress : bool, optional
            Whether to show which part is made, the C compiler's included; requires tqdm.
        **options
            ``fmi`` ('3.0' or '2.0') and ``binary`` (False omits the compiled library) for
            ``.fmu``; ``target`` ('numpy', 'jax' or 'casadi') for ``.py``.

        Returns
        -------
        Exported
            ``path``, ``files``, and ``names``, the identifiers of names that are not valid ones.

        Raises
        ------
        ValueError
            Unknown suffix, or a specified given by a function or by samples.
        GeneratorError
            No C compiler was found for the binary of an FMU, or it failed.

        Examples
        --------
        >>> import os, tempfile
        >>> from pydy.models import n_link_pendulum_on_cart
        >>> system = n_link_pendulum_on_cart(1)
        >>> folder = tempfile.mkdtemp()
        >>> exported = system.export(os.path.join(folder, 'pendulum.c'))
        >>> [file.name for file in exported.files]
        ['pendulum.c', 'pendulum.h']
        """
        from pydy.export.writing import check_options, write

        target = file_of(path, "`path`")
        check_options(target, options)
        title = target.stem if name is None else text(name, "`name`")
        inputs = listed("inputs", inputs, "specifieds of the system", hashable=True)
        with progress_of(flag(progress, "`progress`"), " parts") as told:
            told(0, part="equations")
            model = exported_model(self._now(events), name=title, events=events, inputs=inputs)
            told(1)
            return write(replace(model, told=told), target, **options)
