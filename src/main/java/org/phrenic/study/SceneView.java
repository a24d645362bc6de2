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
            if (s.motion() == Surface.Motion.STILL) {
                now[i] = s.rest().positions();
                continue;
            }
            now[i] = now[i] == null ? new double[s.rest().positions().length] : now[i];
            frame.place(s, i, now[i]);
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
