package org.phrenic.study.measure;

import java.util.List;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.DiaphragmFaces;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/** The surfaces of a scene and the positions of their points at one time, in the frame of the body. */
final class SceneGeometry {
    /** The surfaces in the axes of the scan. */
    private final List<Surface> scanned;

    private final List<Surface> surfaces;
    private final Diaphragm sheet;
    private final double[][] positions;

    /** @param sheet the diaphragm that one of the surfaces shows */
    SceneGeometry(List<Surface> surfaces, Diaphragm sheet) {
        scanned = surfaces;
        this.surfaces = surfaces.stream().map(s -> upright(s, sheet)).toList();
        this.sheet = sheet;
        positions = new double[surfaces.size()][];
    }

    private static Surface upright(Surface s, Diaphragm sheet) {
        TriangleMesh rest = sheet.frame().toFrame(s.rest());
        return new Surface(s.name(), s.kind(), s.level(), s.side(), rest, s.motion(), s.tendon());
    }

    /** Updates all positions from a frame. */
    void update(Frame frame) {
        for (int i = 0; i < positions.length; i++) {
            Surface s = surfaces.get(i);
            if (s.motion() == Surface.Motion.STILL) {
                positions[i] = s.rest().positions();
                continue;
            }
            positions[i] = positions[i] == null ? new double[s.rest().positions().length] : positions[i];
            frame.writePositions(scanned.get(i), i, positions[i]);
            if (!sheet.frame().isStraight()) {
                positions[i] = sheet.frame()
                        .toFrame(s.rest().withPositions(positions[i]))
                        .positions();
            }
        }
    }

    /** A surface, at rest in the frame of the body. */
    Surface surface(int index) {
        return surfaces.get(index);
    }

    /** Points of a surface in the frame of the body, mm; valid until the next {@link #update}. */
    double[] positions(int index) {
        return positions[index];
    }

    /** Indices of all surfaces that satisfy a predicate. */
    int[] indicesOf(Predicate<Surface> which) {
        return IntStream.range(0, surfaces.size())
                .filter(i -> which.test(surfaces.get(i)))
                .toArray();
    }

    int[] indicesOf(StructureKind kind) {
        return indicesOf(s -> s.kind() == kind);
    }

    /** Index of the diaphragm surface. */
    int diaphragm() {
        return indicesOf(StructureKind.DIAPHRAGM)[0];
    }

    /** The diaphragm at rest, with the border of its tendon. */
    Diaphragm sheet() {
        return sheet;
    }

    /** Marks the triangles of the diaphragm that have at least two corners on the thoracic face. */
    boolean[] thoracicTriangles() {
        TriangleMesh rest = surface(diaphragm()).rest();
        DiaphragmFaces faces = new DiaphragmFaces(rest, new MeshTopology(rest));
        int[] t = rest.triangles();
        boolean[] thoracic = new boolean[t.length / 3];
        for (int i = 0; i < thoracic.length; i++) {
            int first = 3 * i;
            thoracic[i] = IntStream.range(first, first + 3)
                            .filter(corner -> faces.isThoracic(t[corner]))
                            .count()
                    >= 2;
        }
        return thoracic;
    }

    /** Array offset of the most lateral point of a side; the first if several are equal. */
    static int mostLateral(double[] points, int sign) {
        int best = 0;
        for (int k = 0; k < points.length; k += 3) {
            best = sign * points[k] > sign * points[best] ? k : best;
        }
        return best;
    }

    /** Name of an observable at a rib level, such as {@code rib_03_pump_deg}. */
    static String name(String kind, int level, String what) {
        return kind + (level < 10 ? "_0" : "_") + level + "_" + what;
    }
}
