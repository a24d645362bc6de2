package org.phrenic.simulation;

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
    /** Depth below the wall at rest up to which the abdominal face is apposed. */
    private static final double APPOSED_MM = 15;
    /** Something more than half of the sheet's 2 to 5 mm. */
    private static final double BEHIND_MM = 1.8;
    /** Struts need to resist the pressure on one node's area only; stiffer ones would shorten the step. */
    private static final double STRUT_STIFFNESS = 0.3;

    final Diaphragm diaphragm;
    final int first;
    final List<AcrossSheet.Pair> links;
    /** Muscle's pairs across the sheet, each vertex in one at most. */
    private final List<AcrossSheet.Pair> musclePairs;
    /** Of each edge of the sheet: share along the fibres, 0 in the tendon, and place from right (0) to left (1) across the midline and from back (0) to front (1). */
    private double[] fibreShare;

    private double[] leftness;
    private double[] frontness;

    DiaphragmPart(
            SceneParts parts,
            Diaphragm diaphragm,
            TissueLaw law,
            double tendonRatio,
            boolean struts,
            int linksPerNode,
            double leftOverRight,
            double frontOverBack) {
        this.diaphragm = diaphragm;
        TriangleMesh sheet = diaphragm.sheet();
        double[] muscle = law.masses(sheet, 1);
        double[] tendon = law.masses(sheet, tendonRatio);
        for (int i = 0; i < muscle.length; i++) {
            muscle[i] = diaphragm.isTendon(i) ? tendon[i] : muscle[i];
        }
        first = parts.addNodes(sheet, muscle);
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
        musclePairs = struts ? across.matched(i -> !diaphragm.isTendon(i) && !diaphragm.isInserted(i), 1) : List.of();
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
            double share = 0;
            int sides = 0;
            for (int s = 2 * e; s < 2 * e + 2; s++) {
                int t = topology.edgeTriangles()[s];
                if (t >= 0) {
                    sides++;
                    share += alongFibre(p, a, b, fibre, t);
                }
            }
            fibreShare[e] = stiff ? 0 : share / sides;
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
        TriangleMesh s = diaphragm.sheet();
        MeshTopology topology = diaphragm.topology();
        int n = musclePairs.size();
        int[] outer = new int[n];
        int[] inner = new int[n];
        int[] triangle = new int[3 * n];
        double[] least = new double[n];
        double[] normals = MeshMeasure.triangleNormals(s);
        for (int i = 0; i < n; i++) {
            AcrossSheet.Pair pair = musclePairs.get(i);
            int a = diaphragm.isThoracic(pair.a()) ? pair.a() : pair.b();
            int b = a == pair.a() ? pair.b() : pair.a();
            outer[i] = first + a;
            inner[i] = first + b;
            int t = topology.vertexTriangles()[topology.vertexTriangleStart()[a]];
            for (int c = 0; c < 3; c++) {
                triangle[3 * i + c] = first + s.triangles()[3 * t + c];
            }
            least[i] = Math.min(LEAST_MM, LEAST_SHARE * along(s.positions(), normals, a, b, t));
        }
        return new OrderedPairs(layout, outer, inner, triangle, least, refresh);
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
