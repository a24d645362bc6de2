package org.phrenic.patient.diaphragm;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.phrenic.anatomy.OrganNames;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.engine.math.DisjointSets;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.EdgeTable;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;
import org.phrenic.mesh.edit.CappedSurface;
import org.phrenic.mesh.edit.LevelClip;
import org.phrenic.mesh.query.TriangleTree;

/**
 * A hiatal hernia: the part of a stomach that lies in the chest, behind the heart, where no base of a lung says where
 * the diaphragm is. A stomach of a scan with two lungs that lie on the diaphragm has one if more than
 * {@value #LEAST_ML} ml of it stand more than {@value #FAR_MM} mm above the roof that lungs and other organs give the
 * diaphragm without it ({@link DomeSurface}), with no base of a lung above them. Both limits are chosen; of eight
 * stomachs in their place 0.2 ml at most do. It is cut where it passes that roof.
 *
 * @param below the stomach without the hernia
 * @param above the hernia, an organ of its own
 */
record HiatalHernia(Structure below, Structure above) {
    static final String STOMACH = "stomach";
    private static final double FAR_MM = 15;
    private static final double LEAST_ML = 10;
    /** Distance of the rim of the part below from the middle of the sheet, mm. */
    private static final double GAP_BELOW_MM = 0.6 * DiaphragmBuilder.THICKNESS_MM;
    /** The same of the part above, mm: the middle of its floor lies up to 2 mm lower, for the sheet is arched. */
    private static final double GAP_ABOVE_MM = GAP_BELOW_MM + 2;
    /** Distance from the hernia within which the part below keeps clear of the sheet, mm. */
    private static final double NECK_MM = 10;

    /**
     * Finds a hernia.
     *
     * @param body the body in the frame of its median plane, without a diaphragm
     * @param cage its envelope
     */
    static Optional<HiatalHernia> of(Thorax body, CageEnvelope cage) {
        Optional<Structure> stomach = body.structures().stream()
                .filter(s -> s.name().toLowerCase(Locale.ROOT).equals(STOMACH) && body.isInScan(s))
                .filter(s -> s.mesh().triangleCount() > 0)
                .findFirst();
        List<LungBase> bases = stomach.isEmpty() ? List.of() : LungBase.of(body);
        if (bases.size() < 2 || !bases.stream().allMatch(base -> base.isInScan() && base.liesOnDiaphragm())) {
            return Optional.empty();
        }
        Structure whole = stomach.get();
        List<Structure> others =
                body.structures().stream().filter(s -> !s.equals(whole)).toList();
        Thorax without = new Thorax(body.name(), others, List.of(), body.notInScan());
        // Without the stomach the base of a lung that lies on it may seem to lie on nothing.
        return LungBase.of(without).stream().allMatch(LungBase::liesOnDiaphragm)
                ? of(whole, DiaphragmBuilder.roof(without, cage), bases)
                : Optional.empty();
    }

    private static Optional<HiatalHernia> of(Structure whole, DomeSurface roof, List<LungBase> bases) {
        TriangleMesh mesh = whole.mesh();
        double[] height = new double[mesh.vertexCount()];
        double[] far = new double[height.length];
        for (int v = 0; v < height.length; v++) {
            height[v] = roof.at(mesh.x(v), mesh.y(v), mesh.z(v));
            far[v] = isBelowBase(mesh, v, bases) ? -FAR_MM : height[v] - FAR_MM;
        }
        if (MeshMeasure.signedVolumeMl(positivePart(mesh, far)) < LEAST_ML) {
            return Optional.empty();
        }
        boolean[] hernia = parts(mesh, height, far);
        double[] above = new double[height.length];
        double[] below = new double[height.length];
        for (int v = 0; v < height.length; v++) {
            above[v] = hernia[v] ? height[v] - GAP_ABOVE_MM : -GAP_ABOVE_MM;
            double near = Math.max(0, 1 - distance(mesh, v, hernia) / NECK_MM);
            below[v] = hernia[v] || near > 0 ? -height[v] - near * GAP_BELOW_MM : FAR_MM;
        }
        Structure upper = new Structure(
                OrganNames.STOMACH_IN_CHEST, StructureKind.ORGAN, 0, Side.MIDLINE, positivePart(mesh, above));
        TriangleMesh lower = positivePart(mesh, below);
        return lower.triangleCount() == 0
                ? Optional.empty()
                : Optional.of(new HiatalHernia(whole.withMesh(lower), upper));
    }

    /** Whether the base of a lung lies above a vertex. */
    private static boolean isBelowBase(TriangleMesh mesh, int v, List<LungBase> bases) {
        TriangleTree.Hit hit = new TriangleTree.Hit();
        return bases.stream()
                .anyMatch(base ->
                        base.tree.nearestAlongRay(mesh.x(v), mesh.y(v), mesh.z(v), 0, 0, 1, hit) && base.isBase(hit));
    }

    /** The closed part of a surface where a function is positive. */
    private static TriangleMesh positivePart(TriangleMesh mesh, double[] values) {
        TriangleMesh open = LevelClip.positivePart(mesh, values);
        return new CappedSurface(open).at(open.positions());
    }

    /** The vertices of connected parts above the roof that reach far above it. */
    private static boolean[] parts(TriangleMesh mesh, double[] height, double[] far) {
        int[] t = mesh.triangles();
        int[] part = DisjointSets.singletons(height.length);
        for (int c = 0; c < t.length; c++) {
            int next = t[EdgeTable.next(c, 3)];
            if (height[t[c]] > 0 && height[next] > 0) {
                DisjointSets.unionToLower(part, t[c], next);
            }
        }
        boolean[] reaches = new boolean[height.length];
        for (int v = 0; v < height.length; v++) {
            reaches[DisjointSets.find(part, v)] |= far[v] > 0;
        }
        boolean[] hernia = new boolean[height.length];
        for (int v = 0; v < height.length; v++) {
            hernia[v] = height[v] > 0 && reaches[DisjointSets.find(part, v)];
        }
        return hernia;
    }

    /** Distance of a vertex from the nearest one of the hernia, mm. */
    private static double distance(TriangleMesh mesh, int v, boolean[] hernia) {
        double[] at = {mesh.x(v), mesh.y(v), mesh.z(v)};
        double least = Double.POSITIVE_INFINITY;
        for (int w = 0; w < hernia.length && !hernia[v]; w++) {
            if (hernia[w]) {
                least = Math.min(least, Vectors.distance(at, new double[] {mesh.x(w), mesh.y(w), mesh.z(w)}));
            }
        }
        return hernia[v] ? 0 : least;
    }

    String note() {
        return Numbers.format(
                "%.0f ml of the stomach lie in the chest, above the diaphragm, as with a hiatal hernia: they are an"
                        + " organ of their own, and the diaphragm passes below them",
                MeshMeasure.signedVolumeMl(above.mesh()));
    }
}
