package org.phrenic.study.measure;

import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/** The surfaces of a scene and where their points are at one time. */
final class SceneGeometry {
    private final List<Surface> surfaces;
    private final double[][] positions;

    SceneGeometry(List<Surface> surfaces) {
        this.surfaces = surfaces;
        positions = new double[surfaces.size()][];
    }

    /** Takes over a frame. */
    void update(Frame frame) {
        for (int i = 0; i < positions.length; i++) {
            Surface s = surfaces.get(i);
            if (s.motion() == Surface.Motion.STILL) {
                positions[i] = s.rest().positions();
                continue;
            }
            positions[i] = positions[i] == null ? new double[s.rest().positions().length] : positions[i];
            frame.writePositions(s, i, positions[i]);
        }
    }

    Surface surface(int index) {
        return surfaces.get(index);
    }

    /** Points of a surface, mm; valid until the next frame. */
    double[] positions(int index) {
        return positions[index];
    }

    /** Numbers of all surfaces of a kind. */
    int[] indicesOf(Predicate<Surface> which) {
        return IntStream.range(0, surfaces.size())
                .filter(i -> which.test(surfaces.get(i)))
                .toArray();
    }

    int[] indicesOf(StructureKind kind) {
        return indicesOf(s -> s.kind() == kind);
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
