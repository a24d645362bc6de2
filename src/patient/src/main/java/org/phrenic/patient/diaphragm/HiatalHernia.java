package org.phrenic.patient.diaphragm;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.engine.math.DisjointSets;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.EdgeTable;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.CappedSurface;
import org.phrenic.mesh.edit.LevelClip;

/**
 * A hiatal hernia: the part of a stomach that lies in the chest. It is cut where it passes the roof that the lungs and
 * the other organs give the diaphragm without it ({@link DomeSurface}). A stomach has one if more than
 * {@value #LEAST_ML} ml of it stand more than {@value #ABOVE_ROOF_MM} mm above that roof, between two lungs of the
 * scan: behind the heart no lung says where the diaphragm is.
 *
 * @param below the stomach without the hernia
 * @param above the hernia, an organ of its own
 */
record HiatalHernia(Structure below, Structure above) {
    private static final String STOMACH = "stomach";
    private static final String NAME = "organ_stomach_above_diaphragm";
    private static final double ABOVE_ROOF_MM = 15;
    private static final double LEAST_ML = 10;
    /** Greatest distance of the middle of a hernia from the median plane, mm. */
    private static final double ASIDE_MM = 50;
    /** Distance of both parts from the middle of the sheet, mm. */
    private static final double GAP_MM = 0.6 * DiaphragmBuilder.THICKNESS_MM;

    /**
     * Finds a hernia.
     *
     * @param body the body in the frame of its median plane, without a diaphragm
     * @throws IllegalArgumentException if the body lacks ribs or spine
     */
    static Optional<HiatalHernia> of(Thorax body) {
        Optional<Structure> stomach = body.structures().stream()
                .filter(s -> s.name().toLowerCase(Locale.ROOT).equals(STOMACH) && body.isInScan(s))
                .findFirst();
        List<LungBase> bases = stomach.isEmpty() ? List.of() : LungBase.of(body);
        if (bases.size() < 2
                || !bases.stream().allMatch(base -> base.isInScan() && base.liesOnDiaphragm())
                || bases.stream().mapToDouble(LungBase::top).min().orElseThrow() + ABOVE_ROOF_MM
                        > stomach.get().mesh().bounds()[5]) {
            return Optional.empty();
        }
        Structure whole = stomach.get();
        List<Structure> others =
                body.structures().stream().filter(s -> !s.equals(whole)).toList();
        CageEnvelope cage = new CageEnvelope(body);
        DomeSurface roof = DiaphragmBuilder.roof(new Thorax(body.name(), others, List.of(), body.notInScan()), cage);
        return of(whole, roof, cage.x(0));
    }

    private static Optional<HiatalHernia> of(Structure whole, DomeSurface roof, double median) {
        TriangleMesh mesh = whole.mesh();
        double[] height = new double[mesh.vertexCount()];
        for (int v = 0; v < height.length; v++) {
            height[v] = roof.at(mesh.x(v), mesh.y(v), mesh.z(v));
        }
        TriangleMesh far = part(mesh, height, 1, ABOVE_ROOF_MM);
        if (far.triangleCount() == 0
                || MeshMeasure.signedVolumeMl(far) < LEAST_ML
                || Math.abs(MeshMeasure.centreOfMass(far)[0] - median) > ASIDE_MM) {
            return Optional.empty();
        }
        keepPartsThatReach(mesh, height, ABOVE_ROOF_MM);
        TriangleMesh below = part(mesh, height, -1, GAP_MM);
        Structure above = new Structure(NAME, StructureKind.ORGAN, 0, Side.MIDLINE, part(mesh, height, 1, GAP_MM));
        return below.triangleCount() == 0
                ? Optional.empty()
                : Optional.of(new HiatalHernia(whole.withMesh(below), above));
    }

    /** The closed part of a surface on one side of the roof, at a distance from it. */
    private static TriangleMesh part(TriangleMesh mesh, double[] height, int side, double gap) {
        double[] values = new double[height.length];
        for (int v = 0; v < values.length; v++) {
            values[v] = side * height[v] - gap;
        }
        TriangleMesh open = LevelClip.positivePart(mesh, values);
        return new CappedSurface(open).at(open.positions());
    }

    /** Moves what stands above the roof without reaching a height to the other side: there the roof is too low. */
    private static void keepPartsThatReach(TriangleMesh mesh, double[] height, double least) {
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
            reaches[DisjointSets.find(part, v)] |= height[v] > least;
        }
        for (int v = 0; v < height.length; v++) {
            if (height[v] > 0 && !reaches[DisjointSets.find(part, v)]) {
                height[v] = -height[v];
            }
        }
    }

    String note() {
        return Numbers.format(
                "%.0f ml of the stomach lie in the chest, above the diaphragm, as with a hiatal hernia: they are kept as"
                        + " an organ of their own, and the diaphragm passes below them",
                MeshMeasure.signedVolumeMl(above.mesh()));
    }
}
