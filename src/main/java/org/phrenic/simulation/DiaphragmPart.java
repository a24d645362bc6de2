package org.phrenic.simulation;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.phrenic.anatomy.AcrossSheet;
import org.phrenic.anatomy.ChestWall;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.engine.NodeLayout;
import org.phrenic.engine.constraint.OrderedPairs;
import org.phrenic.geometry.MeshMeasure;
import org.phrenic.geometry.MeshTopology;
import org.phrenic.geometry.TriangleMesh;

/**
 * The diaphragm as part of a scene: springs along its edges (contractile along the fibres in muscle), struts across its thickness, rigid links in the tendon, and the lists of nodes that bone holds, that slide
 * on the chest wall, and of faces that the abdomen presses on.
 */
final class DiaphragmPart {
    /** Farthest opposing vertex that is still across the sheet, mm: the sheet is 2 to 5 mm thick, segmentations of it up to four times that. */
    private static final double REACH_MM = 20;

    private static final int STRUTS = 2;
    private static final double MIDLINE_MM = 20;
    private static final double FRONT_MM = 50;
    /** The faces of muscle stay at least so far apart, as a share of their distance at rest and at most. */
    private static final double LEAST_SHARE = 0.4;

    private static final double LEAST_MM = 1.5;
    /** A pair that leans more than this cosine, as at the rim of an opening, says nothing of inside and outside: kept in order, such pairs threw nodes to and fro by millimetres. */
    private static final double UPRIGHT = 0.5;
    /** Depth below the wall at rest up to which the abdominal face is apposed. */
    private static final double APPOSED_MM = 15;
    /** Something more than half of the sheet's 2 to 5 mm. */
    private static final double BEHIND_MM = 1.8;
    /** Struts need to resist the pressure on one node's area only; stiffer ones would shorten the step. */
    private static final double STRUT_STIFFNESS = 0.3;
    /** Of the bed that the crura's origin lies in: against muscle's pull of some kPa over a sheet of some mm it gives by a millimetre or two. */
    private static final double CRURAL_KPA_PER_MM = 1;

    final Diaphragm diaphragm;
    final int first;
    final List<AcrossSheet.Pair> links;
    /** How much of each vertex is the tendinous origin of the crura, 0 to 1: so much less does muscle shorten there. */
    private final double[] origin;

    /** Nodes of the scene at that origin, but for those that bone holds exactly. */
    final int[] cruralNodes;
    /** Stiffness of what holds each of these to the vertebrae, N/m: in proportion to its area, so that finer meshes are held alike. */
    final double[] cruralStiffnesses;
    /** Muscle's pairs across the sheet, each vertex in one at most. */
    private final List<Ordered> ordered;
    /** Of each edge of the sheet: share along the fibres, 0 in the tendon, and place from right (0) to left (1) across the midline and from back (0) to front (1). */
    private double[] fibreShare;

    private double[] leftness;
    private double[] frontness;

    DiaphragmPart(
            SceneParts parts,
            Diaphragm diaphragm,
            double[] origin,
            TissueLaw law,
            double tendonRatio,
            boolean struts,
            int linksPerNode,
            double leftOverRight,
            double frontOverBack) {
        this.diaphragm = diaphragm;
        this.origin = origin;
        TriangleMesh sheet = diaphragm.sheet();
        double[] muscle = law.masses(sheet, 1);
        double[] tendon = law.masses(sheet, tendonRatio);
        for (int i = 0; i < muscle.length; i++) {
            muscle[i] = diaphragm.isTendon(i) ? tendon[i] : muscle[i];
        }
        first = parts.addNodes(sheet, muscle);
        int[] crural = IntStream.range(0, origin.length)
                .filter(i -> origin[i] > 0 && !diaphragm.isInserted(i))
                .toArray();
        double[] areas = MeshMeasure.vertexAreas(sheet);
        cruralNodes = SceneParts.shifted(crural, first);
        cruralStiffnesses = IntStream.of(crural)
                .mapToDouble(i -> CRURAL_KPA_PER_MM * origin[i] * areas[i])
                .toArray();
        addEdges(parts.diaphragm, law, tendonRatio, leftOverRight, frontOverBack);
        AcrossSheet across = AcrossSheet.of(diaphragm, REACH_MM);
        if (struts) {
            double[] p = sheet.positions();
            for (AcrossSheet.Pair pair : across.nearest(STRUTS)) {
                parts.diaphragm.add(
                        first + pair.a(),
                        first + pair.b(),
                        law.edgeStiffness(2, STRUT_STIFFNESS),
                        SceneParts.distance(p, pair.a(), p, pair.b()),
                        0);
            }
        }
        links = across.matched(diaphragm::isTendon, linksPerNode);
        ordered = struts
                ? ordered(across.matched(i -> !diaphragm.isTendon(i) && !diaphragm.isInserted(i), 1))
                : List.of();
    }

    private void addEdges(
            SpringList springs, TissueLaw law, double tendonRatio, double leftOverRight, double frontOverBack) {
        TriangleMesh sheet = diaphragm.sheet();
        MeshTopology topology = diaphragm.topology();
        double[] p = sheet.positions();
        double[] fibre = diaphragm.fibreDirections();
        double[] box = sheet.bounds();
        double middle = 0.5 * (box[0] + box[3]);
        double middleY = 0.5 * (box[1] + box[4]);
        fibreShare = new double[topology.edgeCount()];
        leftness = new double[topology.edgeCount()];
        frontness = new double[topology.edgeCount()];
        for (int e = 0; e < topology.edgeCount(); e++) {
            int a = topology.edges()[2 * e];
            int b = topology.edges()[2 * e + 1];
            boolean stiff = diaphragm.isTendon(a) && diaphragm.isTendon(b);
            int one = topology.edgeTriangles()[2 * e];
            int other = topology.edgeTriangles()[2 * e + 1];
            int sides = (one >= 0 ? 1 : 0) + (other >= 0 ? 1 : 0);
            double share = (one >= 0 ? alongFibre(p, a, b, fibre, one) : 0)
                    + (other >= 0 ? alongFibre(p, a, b, fibre, other) : 0);
            fibreShare[e] = stiff ? 0 : share / sides * (1 - 0.5 * (origin[a] + origin[b]));
            leftness[e] = share(0.5 * (sheet.x(a) + sheet.x(b)) - middle, MIDLINE_MM);
            frontness[e] = share(middleY - 0.5 * (sheet.y(a) + sheet.y(b)), FRONT_MM);
            springs.add(
                    first + a,
                    first + b,
                    law.edgeStiffness(sides, stiff ? tendonRatio : 1),
                    SceneParts.distance(p, a, p, b),
                    fibreShare[e] * drive(leftness[e], leftOverRight) * drive(frontness[e], frontOverBack));
        }
    }

    /** Share of the muscle's drive that a place left (+) or right (-) of the middle takes: 1 on the stronger side, changing smoothly across the midline. */
    private static double drive(double leftness, double leftOverRight) {
        double right = Math.min(1, 1 / leftOverRight);
        double left = Math.min(1, leftOverRight);
        return right + (left - right) * leftness * leftness * (3 - 2 * leftness);
    }

    private static double share(double x, double halfWidth) {
        return Math.max(0, Math.min(1, 0.5 + 0.5 * x / halfWidth));
    }

    /** For each triangle that the abdomen presses on how much of it counts as left, 0 to 1, smooth across the midline. */
    double[] abdominalLeftness() {
        TriangleMesh sheet = diaphragm.sheet();
        double[] box = sheet.bounds();
        double middle = 0.5 * (box[0] + box[3]);
        int[] t = sheet.triangles();
        return IntStream.range(0, sheet.triangleCount())
                .filter(i -> !diaphragm.isThoracicTriangle(i))
                .mapToDouble(i -> (sheet.x(t[3 * i]) + sheet.x(t[3 * i + 1]) + sheet.x(t[3 * i + 2])) / 3 - middle)
                // With nothing at all on the right, what is left of a drive is the smooth step to the left.
                .map(x -> drive(share(x, MIDLINE_MM), Double.POSITIVE_INFINITY))
                .toArray();
    }

    /** Share of the activation that shortens an edge of the sheet, the edges in the order of their springs. */
    double contractileShare(int edge, double leftOverRight, double frontOverBack) {
        return edge < fibreShare.length
                ? fibreShare[edge] * drive(leftness[edge], leftOverRight) * drive(frontness[edge], frontOverBack)
                : 0;
    }

    /** Whether a spring of the sheet, in the order of its springs, is an edge in the tendon. */
    boolean isTendonEdge(int spring) {
        int[] edges = diaphragm.topology().edges();
        return spring < fibreShare.length
                && diaphragm.isTendon(edges[2 * spring])
                && diaphragm.isTendon(edges[2 * spring + 1]);
    }

    /** Share along the fibres of an edge of the sheet. */
    double[] fibreShares() {
        return fibreShare;
    }

    /** cos⁴ of the angle between an edge and the fibres of a triangle, 0 in the tendon: muscle shortens along its fibres and hardly across them (Boriek and Rodarte 1997), so a slanting edge shortens less than cos² would have it. */
    private static double alongFibre(double[] p, int a, int b, double[] fibre, int triangle) {
        double dot = 0;
        double squared = 0;
        for (int axis = 0; axis < 3; axis++) {
            double d = p[3 * b + axis] - p[3 * a + axis];
            dot += d * fibre[3 * triangle + axis];
            squared += d * d;
        }
        double cosine2 = dot * dot / squared;
        return cosine2 * cosine2;
    }

    /** Vertices of the sheet that bone holds. */
    int[] inserted() {
        return IntStream.range(0, diaphragm.sheet().vertexCount())
                .filter(diaphragm::isInserted)
                .toArray();
    }

    /**
     * Vertices of the sheet that the chest wall stops: the thoracic face of the muscle, and the abdominal face where it is apposed, for a strut keeps its length but would let the two faces change places.
     */
    int[] sliding(ChestWall wall) {
        TriangleMesh s = diaphragm.sheet();
        return IntStream.range(0, s.vertexCount())
                .filter(i -> !diaphragm.isTendon(i) && !diaphragm.isInserted(i))
                .filter(i -> diaphragm.isThoracic(i) || wall.depth(s.x(i), s.y(i), s.z(i)) < APPOSED_MM)
                .toArray();
    }

    /** How far inside the wall a vertex is stopped, mm. */
    double inset(int vertex) {
        return diaphragm.isThoracic(vertex) ? 0 : BEHIND_MM;
    }

    /** What keeps the thoracic face outside the abdominal one in muscle. */
    OrderedPairs order(NodeLayout layout, double refresh) {
        int[] t = diaphragm.sheet().triangles();
        return new OrderedPairs(
                layout,
                ordered.stream().mapToInt(p -> first + p.outer).toArray(),
                ordered.stream().mapToInt(p -> first + p.inner).toArray(),
                ordered.stream()
                        .flatMapToInt(p -> IntStream.range(3 * p.triangle, 3 * p.triangle + 3))
                        .map(c -> first + t[c])
                        .toArray(),
                ordered.stream().mapToDouble(p -> p.least).toArray(),
                refresh);
    }

    /**
     * Vertices on the two faces that may not change places.
     *
     * @param triangle of the outer face, whose normal says where outside is
     * @param least distance along it, mm
     */
    private record Ordered(int outer, int inner, int triangle, double least) {}

    /** Of pairs across muscle those that stand upright on the sheet. */
    private List<Ordered> ordered(List<AcrossSheet.Pair> pairs) {
        TriangleMesh s = diaphragm.sheet();
        MeshTopology topology = diaphragm.topology();
        double[] p = s.positions();
        double[] normals = MeshMeasure.triangleNormals(s);
        List<Ordered> out = new ArrayList<>();
        for (AcrossSheet.Pair pair : pairs) {
            int a = diaphragm.isThoracic(pair.a()) ? pair.a() : pair.b();
            int b = a == pair.a() ? pair.b() : pair.a();
            int t = topology.vertexTriangles()[topology.vertexTriangleStart()[a]];
            double along = along(p, normals, a, b, t);
            if (along > UPRIGHT * SceneParts.distance(p, a, p, b)) {
                out.add(new Ordered(a, b, t, Math.min(LEAST_MM, LEAST_SHARE * along)));
            }
        }
        return out;
    }

    /** Distance of a from b along the normal of a triangle. */
    private static double along(double[] p, double[] normals, int a, int b, int triangle) {
        double sum = 0;
        for (int axis = 0; axis < 3; axis++) {
            sum += normals[3 * triangle + axis] * (p[3 * a + axis] - p[3 * b + axis]);
        }
        return sum;
    }

    /** Vertices that an action line may pull: all that bone does not hold, for a line goes through the dome, tendon and muscle alike. */
    int[] free() {
        return IntStream.range(0, diaphragm.sheet().vertexCount())
                .filter(i -> !diaphragm.isInserted(i))
                .toArray();
    }

    /** Where the action line of a side (-1 right, 1 left) stands: x and y, mm. */
    double[] linePlace(int side) {
        double[] box = diaphragm.sheet().bounds();
        return new double[] {0.5 * (box[0] + box[3]) + side * 0.25 * (box[3] - box[0]), 0.5 * (box[1] + box[4])};
    }

    /** Triangles that the abdomen presses on, as nodes of the scene. */
    int[] abdominalTriangles() {
        int[] t = diaphragm.sheet().triangles();
        return IntStream.range(0, diaphragm.sheet().triangleCount())
                .filter(i -> !diaphragm.isThoracicTriangle(i))
                .flatMap(i -> IntStream.range(3 * i, 3 * i + 3))
                .map(i -> first + t[i])
                .toArray();
    }
}
