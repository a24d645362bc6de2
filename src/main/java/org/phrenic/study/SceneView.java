package org.phrenic.study;

import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.simulation.Frame;
import org.phrenic.simulation.Surface;

/** The surfaces of a scene and where their points are at one time. */
final class SceneView {
    private final List<Surface> surfaces;
    private final double[][] now;

    SceneView(List<Surface> surfaces) {
        this.surfaces = surfaces;
        now = new double[surfaces.size()][];
    }

    /** Takes over a frame. */
    void show(Frame frame) {
        for (int i = 0; i < now.length; i++) {
            Surface s = surfaces.get(i);
            double[] rest = s.rest().positions();
            switch (s.motion()) {
                case STILL -> now[i] = rest;
                case DEFORMING -> {
                    now[i] = now[i] == null ? new double[rest.length] : now[i];
                    float[] p = frame.positions(i);
                    for (int k = 0; k < p.length; k++) {
                        now[i][k] = p[k];
                    }
                }
                case RIGID -> {
                    now[i] = now[i] == null ? new double[rest.length] : now[i];
                    move(frame.pose(i), rest, now[i]);
                }
            }
        }
    }

    /** Moves points by a pose: three rows of a rotation and a translation. */
    static void move(float[] pose, double[] from, double[] to) {
        for (int k = 0; k < from.length; k += 3) {
            for (int row = 0; row < 3; row++) {
                int r = 4 * row;
                to[k + row] = pose[r] * from[k] + pose[r + 1] * from[k + 1] + pose[r + 2] * from[k + 2] + pose[r + 3];
            }
        }
    }

    Surface surface(int index) {
        return surfaces.get(index);
    }

    /** Points of a surface, mm; valid until the next frame. */
    double[] now(int index) {
        return now[index];
    }

    /** Numbers of all surfaces of a kind. */
    int[] all(Predicate<Surface> which) {
        return IntStream.range(0, surfaces.size())
                .filter(i -> which.test(surfaces.get(i)))
                .toArray();
    }

    int[] all(StructureKind kind) {
        return all(s -> s.kind() == kind);
    }

    /** The surface of this kind, level and side. */
    Optional<Integer> find(StructureKind kind, int level, Side side) {
        return IntStream.range(0, surfaces.size())
                .filter(i -> surfaces.get(i).kind() == kind
                        && surfaces.get(i).level() == level
                        && surfaces.get(i).side() == side)
                .boxed()
                .findFirst();
    }
}
