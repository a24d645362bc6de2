package org.phrenic.model.material;

import org.phrenic.engine.force.ActionLine;
import org.phrenic.model.assembly.Scene;
import org.phrenic.model.assembly.ScenePart;
import org.phrenic.model.organ.DiaphragmPart;
import org.phrenic.model.organ.MassSpringBuilder;
import org.phrenic.parameter.Effect;
import org.phrenic.parameter.Group;
import org.phrenic.parameter.Parameter;
import org.phrenic.parameter.RampedValue;

/** Muscle force of Villard, Bourne and Bello 2009: one action line through the centre of each hemidiaphragm. */
public final class ActionLines extends ScenePart {
    public static final Parameter MUSCLE_FORCE = Parameter.named("muscle_force_mn", "Muscle force")
            .range(0, 1000, "mN")
            .initial(300)
            .group(Group.MUSCLE)
            .switchedBy(Muscle.MUSCLE)
            .describedAs(
                    "Force on a node on an action line at full drive (chosen; the source of the model gives none).");
    public static final Parameter ACTION_RADIUS = Parameter.named("action_line_radius_mm", "Action line radius")
            .range(5, 200, "mm")
            .initial(60)
            .shown(Group.MUSCLE, Effect.SCENE)
            .describedAs("Distance from an action line at which its force has fallen to nothing.");
    public static final Parameter FORCE_LEFT_OVER_RIGHT = Parameter.named(
                    "muscle_force_left_over_right", "Muscle force left over right")
            .range(0.2, 5)
            .initial(1)
            .group(Group.MUSCLE)
            .fitted(0.4, 2.5)
            .describedAs("Force of the left action line over that of the right; the stronger takes muscle_force_mn.");

    public ActionLines() {
        super(Stage.ACTION_LINES, MUSCLE_FORCE, ACTION_RADIUS, FORCE_LEFT_OVER_RIGHT);
    }

    @Override
    public void addTo(Scene scene) {
        DiaphragmPart diaphragm = scene.diaphragm();
        int[] nodes = MassSpringBuilder.offset(diaphragm.freeVertices(), diaphragm.firstNode);
        RampedValue force = scene.ramped(MUSCLE_FORCE);
        RampedValue radius = scene.ramped(ACTION_RADIUS);
        RampedValue leftOverRight = scene.ramped(FORCE_LEFT_OVER_RIGHT);
        for (int side = -1; side <= 1; side += 2) {
            double[] place = diaphragm.actionLinePosition(side);
            ActionLine line =
                    new ActionLine(scene.layout(), nodes, scene.restPositions(), place[0], place[1], radius.target());
            scene.system().add(line);
            scene.drawActionLine(place);
            boolean left = side > 0;
            scene.drive().beforeForces((time, breath) -> {
                double ratio = leftOverRight.at(time);
                line.setForce(force.at(time) * Math.min(1, left ? ratio : 1 / ratio) * breath.activation);
            });
            scene.tuning().whileRamping(time -> line.setRadius(radius.at(time)));
        }
    }
}
