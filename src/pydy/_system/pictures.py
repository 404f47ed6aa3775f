"""Scenes, plots and animations of a System."""

from __future__ import annotations

from functools import partial
from operator import attrgetter
from typing import TYPE_CHECKING, Any

from pydy._simulation.exporting import live_system
from pydy._simulation.problem import read_numbers
from pydy._system.simulation import Simulation
from pydy.trajectory import Trajectory

if TYPE_CHECKING:
    from pydy.viz.live import LiveSystem
    from pydy.viz.scene import Scene


class Pictures(Simulation):
    """Scenes, plots and animations."""

    def _motion(self, times: Any, states: Any) -> Trajectory:
        """Return a trajectory of checked arrays, and the model that moves the scene."""
        problem = self._now()
        kinds = problem.definition.symbols_by_kind
        symbols = {k: v for k, v in kinds.items() if k not in ("output", "constraint", "force")}
        along = problem.specifieds(times, states)
        return Trajectory(times, states, symbols, specifieds=along, constants=problem.constants)

    def _live_system(self, *, events: Any = None, **options: Any) -> LiveSystem:
        """Return what a page that simulates needs."""
        return live_system(self._now(events), events=events, **options)

    def scene(
        self, *visuals: Any, reference_frame: Any = None, origin: Any = None, **options: Any
    ) -> Scene:
        """Return a scene of the system, which can be animated and written as an HTML page.

        Parameters
        ----------
        *visuals : pydy.viz.Visual, RigidBody or Particle
            By default what points and frames show: bars between the joints of bodies, ropes,
            springs, dampers, wheels and supports; a ball for each Particle; and a solid with the
            same inertia for a RigidBody without further points.
        reference_frame : ReferenceFrame, optional
            By default the inertial frame.
        origin : Point, optional
            By default a point at rest in that frame, connected with the bodies.
        **options
            `loads`: whether to show forces and torques as arrows. Options of `pydy.viz.Scene`:
            `up` (by default against gravity), `ground`, `follow`, `view`, `series`, `units` and
            `title`.

        Returns
        -------
        pydy.viz.Scene

        Raises
        ------
        ValueError
            There are no bodies to show, or no point that can be the origin.

        Examples
        --------
        >>> import numpy as np
        >>> from pydy.models import n_link_pendulum_on_cart
        >>> system = n_link_pendulum_on_cart(2)
        >>> system.initial_conditions = {system.coordinates[1]: 0.5}
        >>> system.times = np.linspace(0.0, 1.0, num=61)
        >>> scene = system.scene().animate(system.simulate())
        >>> scene.poses.shape
        (61, 5, 4, 4)

        ``scene.to_html('pendulum.html')`` writes the page, ``scene.show()`` opens it.
        """
        from pydy._simulation.scene import make_scene

        definition = self._definition
        constants = read_numbers(definition, "constants", self._constants, None)
        given = {"reference_frame": reference_frame, "origin": origin, **options}
        numbers = dict(zip(definition.constants, constants.tolist(), strict=True))
        assembly = partial(attrgetter("model.assembly"), self)
        moving = partial(attrgetter("_times"), self), self._motion, self._live_system
        return make_scene(definition, numbers, assembly, visuals, given, moving)

    def _moved(self, contacts: Any, method: str) -> Trajectory:
        """Simulate with contacts or without; refuse to leave out those that were made."""
        if contacts is not None:
            moved: Trajectory = self._checked_contacts(contacts).simulate()
            return moved
        if self._has_contacts:
            raise ValueError(
                f"`system.{method}()` knows no contacts, and `Contacts` were made of this system: "
                f"bodies would fall through the ground. Pass `system.{method}(contacts=contacts)`, "
                "or, for the motion without them, use what `system.simulate()` returns."
            )
        return self.simulate()

    def plot(self, names: list[Any] | None = None, *, contacts: Any = None, **options: Any) -> Any:
        """Simulate, and plot the states or selected quantities over time.

        Equivalent to ``system.simulate().plot(...)``; see `pydy.trajectory.Trajectory.plot`. For
        several plots, keep the trajectory and use its own method.

        Parameters
        ----------
        names : list of symbols or names, optional
        contacts : pydy.contact.Contacts, optional
            Contacts of this system, with which it is simulated.
        **options
            Those of `pydy.trajectory.Trajectory.plot`.

        Raises
        ------
        ValueError
            There are `Contacts` of this system, and none were passed.

        Examples
        --------
        >>> from pydy.models import multi_mass_spring_damper
        >>> system = multi_mass_spring_damper()
        >>> system.initial_conditions = {'x0': 1.0}
        >>> system.times = [0.0, 0.5, 1.0]
        >>> system.plot(['x0']).get_ylabel()
        'value'
        """
        return self._moved(contacts, "plot").plot(names, **options)

    def animate(self, *visuals: Any, contacts: Any = None, **options: Any) -> Scene:
        """Simulate, and return an animated scene, which a notebook displays.

        Equivalent to ``system.scene(...).animate(system.simulate())``, with the arguments of
        `scene`.

        Parameters
        ----------
        *visuals
            As in `scene`.
        contacts : pydy.contact.Contacts, optional
            Contacts of this system, with which it is simulated.
        **options
            Those of `scene`.

        Raises
        ------
        ValueError
            There are `Contacts` of this system, and none were passed; or as in `scene`.
        """
        return self.scene(*visuals, **options).animate(self._moved(contacts, "animate"))
