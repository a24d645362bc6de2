package org.phrenic.model.organ;

import java.util.List;
import java.util.stream.IntStream;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.OpposingVertices;
import org.phrenic.anatomy.cage.MovingChestWall;
import org.phrenic.engine.constraint.NonInversionPairs;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;

/**
 * The diaphragm as part of a scene: springs along its edges (contractile along the fibres in muscle), struts across its
 * thickness, rigid links in the tendon, and the lists of nodes that bone holds, that slide on the chest wall, and of
 * faces that the abdomen presses on.
 */
public final class DiaphragmPart {
    /**
     * Farthest opposing vertex that is still across the sheet, mm: the sheet is 2 to 5 mm thick, segmentations of it up
     * to four times that.
     */
    private static final double REACH_MM = 20;

    private static final int STRUTS = 2;
    private static final double MIDLINE_MM = 20;
    private static final double FRONT_MM = 50;
    /** Depth below the wall at rest up to which the abdominal face is apposed. */
    private static final double APPOSED_MM = 15;
    /** Something more than half of the sheet's 2 to 5 mm. */
    private static final double BEHIND_MM = 1.8;
    /** Struts need to resist the pressure on one node's area only; stiffer ones would shorten the step. */
    private static final double STRUT_STIFFNESS = 0.3;
    /**
     * Of the bed that the crura's origin lies in: against muscle's pull of some kPa over a sheet of some mm it gives by
     * a millimetre or two.
     */
    private static final double CRURAL_KPA_PER_MM = 1;

    public final Diaphragm diaphragm;
    public final int firstNode;
    public final List<OpposingVertices.Pair> links;
    /** How much of each vertex is the tendinous origin of the crura, 0 to 1: so much less does muscle shorten there. */
    private final double[] cruralShare;

    /** Nodes of the scene at that origin, but for those that bone holds exactly. */
    public final int[] cruralNodes;
    /**
     * Stiffness of what holds each of these to the vertebrae, N/m: in proportion to its area, so that finer meshes are
     * held alike.
     */
    public final double[] cruralStiffnesses;

    private final FaceOrder faceOrder;
    /**
     * Of each edge of the sheet: share along the fibres, 0 in the tendon, and place from right (0) to left (1) across
     * the midline and from back (0) to front (1).
     */
    private double[] fibreShare;

    private double[] leftShare;
    private double[] frontShare;

    private DiaphragmPart(Builder from, MassSpringBuilder parts) {
        double[] origin = from.crura;
        TissueLaw law = from.law;
        double tendonRatio = from.tendonRatio;
        diaphragm = from.diaphragm;
        this.cruralShare = origin;
        TriangleMesh sheet = diaphragm.sheet();
        double[] muscle = law.masses(sheet, 1);
        double[] tendon = law.masses(sheet, tendonRatio);
        for (int i = 0; i < muscle.length; i++) {
            muscle[i] = diaphragm.isTendon(i) ? tendon[i] : muscle[i];
        }
        firstNode = parts.addNodes(sheet, muscle);
        int[] crural = IntStream.range(0, origin.length)
                .filter(i -> origin[i] > 0 && !diaphragm.isInserted(i))
                .toArray();
        double[] areas = MeshMeasure.vertexAreas(sheet);
        cruralNodes = MassSpringBuilder.offset(crural, firstNode);
        cruralStiffnesses = IntStream.of(crural)
                .mapToDouble(i -> CRURAL_KPA_PER_MM * origin[i] * areas[i])
                .toArray();
        addEdges(parts.sheetSprings, from);
        OpposingVertices across = OpposingVertices.of(diaphragm, REACH_MM);
        if (from.struts) {
            double[] p = sheet.positions();
            for (OpposingVertices.Pair pair : across.nearestPairs(STRUTS)) {
                parts.sheetSprings.add(
                        firstNode + pair.a(),
                        firstNode + pair.b(),
                        law.edgeStiffness(2, STRUT_STIFFNESS),
                        MassSpringBuilder.distance(p, pair.a(), p, pair.b()),
                        0);
            }
        }
        links = across.greedyMatching(diaphragm::isTendon, from.linksPerNode);
        faceOrder = new FaceOrder(
                diaphragm,
                from.struts
                        ? across.greedyMatching(i -> !diaphragm.isTendon(i) && !diaphragm.isInserted(i), 1)
                        : List.of());
    }

    private void addEdges(SpringList springs, Builder from) {
        TriangleMesh sheet = diaphragm.sheet();
        MeshTopology topology = diaphragm.topology();
        double[] p = sheet.positions();
        double[] fibre = diaphragm.fibreDirections();
        double[] box = sheet.bounds();
        double middle = 0.5 * (box[0] + box[3]);
        double middleY = 0.5 * (box[1] + box[4]);
        fibreShare = new double[topology.edgeCount()];
        leftShare = new double[topology.edgeCount()];
        frontShare = new double[topology.edgeCount()];
        for (int e = 0; e < topology.edgeCount(); e++) {
            int a = topology.edges()[2 * e];
            int b = topology.edges()[2 * e + 1];
            boolean stiff = diaphragm.isTendon(a) && diaphragm.isTendon(b);
            int one = topology.face(e, 0);
            int other = topology.face(e, 1);
            int sides = (one >= 0 ? 1 : 0) + (other >= 0 ? 1 : 0);
            double share = (one >= 0 ? alongFibre(p, a, b, fibre, one) : 0)
                    + (other >= 0 ? alongFibre(p, a, b, fibre, other) : 0);
            fibreShare[e] = stiff ? 0 : share / sides * (1 - 0.5 * (cruralShare[a] + cruralShare[b]));
            leftShare[e] = smoothShare(0.5 * (sheet.x(a) + sheet.x(b)) - middle, MIDLINE_MM);
            frontShare[e] = smoothShare(middleY - 0.5 * (sheet.y(a) + sheet.y(b)), FRONT_MM);
            springs.add(
                    firstNode + a,
                    firstNode + b,
                    from.law.edgeStiffness(sides, stiff ? from.tendonRatio : 1),
                    MassSpringBuilder.distance(p, a, p, b),
                    fibreShare[e]
                            * driveShare(leftShare[e], from.leftOverRight)
                            * driveShare(frontShare[e], from.frontOverBack));
        }
    }

    /**
     * Share of the muscle's drive that a place left (+) or right (-) of the middle takes: 1 on the stronger side,
     * changing smoothly across the midline.
     */
    private static double driveShare(double leftness, double leftOverRight) {
        double right = Math.min(1, 1 / leftOverRight);
        double left = Math.min(1, leftOverRight);
        return right + (left - right) * leftness * leftness * (3 - 2 * leftness);
    }

    private static double smoothShare(double x, double halfWidth) {
        return Math.max(0, Math.min(1, 0.5 + 0.5 * x / halfWidth));
    }

    /**
     * For each triangle that the abdomen presses on how much of it counts as left, 0 to 1, smooth across the midline.
     */
    public double[] abdominalLeftShares() {
        TriangleMesh sheet = diaphragm.sheet();
        double[] box = sheet.bounds();
        double middle = 0.5 * (box[0] + box[3]);
        int[] t = sheet.triangles();
        return IntStream.range(0, sheet.triangleCount())
                .filter(i -> !diaphragm.isThoracicTriangle(i))
                .mapToDouble(i -> (sheet.x(t[3 * i]) + sheet.x(t[3 * i + 1]) + sheet.x(t[3 * i + 2])) / 3 - middle)
                // With nothing at all on the right, what is left of a drive is the smooth step to the left.
                .map(x -> driveShare(smoothShare(x, MIDLINE_MM), Double.POSITIVE_INFINITY))
                .toArray();
    }

    /** Share of the activation that shortens an edge of the sheet, the edges in the order of their springs. */
    public double contractileShare(int edge, double leftOverRight, double frontOverBack) {
        return edge < fibreShare.length
                ? fibreShare[edge]
                        * driveShare(leftShare[edge], leftOverRight)
                        * driveShare(frontShare[edge], frontOverBack)
                : 0;
    }

    /** Whether a spring of the sheet, in the order of its springs, is an edge in the tendon. */
    public boolean isTendonEdge(int spring) {
        int[] edges = diaphragm.topology().edges();
        return spring < fibreShare.length
                && diaphragm.isTendon(edges[2 * spring])
                && diaphragm.isTendon(edges[2 * spring + 1]);
    }

    /** Share along the fibres of an edge of the sheet. */
    public double[] fibreShares() {
        return fibreShare;
    }

    /**
     * cos⁴ of the angle between an edge and the fibres of a triangle, 0 in the tendon: muscle shortens along its fibres
     * and hardly across them (Boriek and Rodarte 1997), so a slanting edge shortens less than cos² would have it.
     */
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
    public int[] insertedVertices() {
        return IntStream.range(0, diaphragm.sheet().vertexCount())
                .filter(diaphragm::isInserted)
                .toArray();
    }

    /**
     * Vertices of the sheet that the chest wall stops: the thoracic face of the muscle, and the abdominal face where it
     * is apposed, for a strut keeps its length but would let the two faces change places.
     */
    public int[] slidingVertices(MovingChestWall wall) {
        TriangleMesh s = diaphragm.sheet();
        return IntStream.range(0, s.vertexCount())
                .filter(i -> !diaphragm.isTendon(i) && !diaphragm.isInserted(i))
                .filter(i -> diaphragm.isThoracic(i) || wall.depth(s.x(i), s.y(i), s.z(i)) < APPOSED_MM)
                .toArray();
    }

    /** How far inside the wall a vertex is stopped, mm. */
    public double wallInset(int vertex) {
        return diaphragm.isThoracic(vertex) ? 0 : BEHIND_MM;
    }

    /** What keeps the thoracic face outside the abdominal one in muscle. */
    public NonInversionPairs orderedPairs(NodeLayout layout, double refresh) {
        return faceOrder.constraint(layout, firstNode, refresh);
    }

    /**
     * Vertices that an action line may pull: all that bone does not hold, for a line goes through the dome, tendon and
     * muscle alike.
     */
    public int[] freeVertices() {
        return IntStream.range(0, diaphragm.sheet().vertexCount())
                .filter(i -> !diaphragm.isInserted(i))
                .toArray();
    }

    /** Where the action line of a side (-1 right, 1 left) stands: x and y, mm. */
    public double[] actionLinePosition(int side) {
        double[] box = diaphragm.sheet().bounds();
        return new double[] {0.5 * (box[0] + box[3]) + side * 0.25 * (box[3] - box[0]), 0.5 * (box[1] + box[4])};
    }

    /** Triangles that the abdomen presses on, as nodes of the scene. */
    public int[] abdominalTriangles() {
        int[] t = diaphragm.sheet().triangles();
        return IntStream.range(0, diaphragm.sheet().triangleCount())
                .filter(i -> !diaphragm.isThoracicTriangle(i))
                .flatMap(i -> IntStream.range(3 * i, 3 * i + 3))
                .map(i -> firstNode + t[i])
                .toArray();
    }

    /**
     * Begins the diaphragm of a scene; without more it is a sheet without struts whose muscle is driven alike
     * everywhere.
     */
    public static Builder builder(Diaphragm diaphragm, TissueLaw law) {
        return new Builder(diaphragm, law);
    }

    /** What a diaphragm is made with. */
    public static final class Builder {
        private final Diaphragm diaphragm;
        private final TissueLaw law;
        private double[] crura;
        private double tendonRatio = 1;
        private boolean struts;
        private int linksPerNode = 1;
        private double leftOverRight = 1;
        private double frontOverBack = 1;

        private Builder(Diaphragm diaphragm, TissueLaw law) {
            this.diaphragm = diaphragm;
            this.law = law;
            crura = new double[diaphragm.sheet().vertexCount()];
        }

        /** How much of each vertex is the tendinous origin of the crura, 0 to 1. */
        public Builder crura(double[] shares) {
            crura = shares;
            return this;
        }

        /** Stiffness of the tendon over that of muscle. */
        public Builder tendonRatio(double ratio) {
            tendonRatio = ratio;
            return this;
        }

        /** With springs across the thickness, and pairs that keep the order of the faces. */
        public Builder withStruts() {
            struts = true;
            return this;
        }

        /** Rigid links a node of the tendon. */
        public Builder linksPerNode(int count) {
            linksPerNode = count;
            return this;
        }

        /** Activation of the left over the right, and of the front over the back. */
        public Builder driveRatios(double leftRight, double frontBack) {
            leftOverRight = leftRight;
            frontOverBack = frontBack;
            return this;
        }

        /** Adds its nodes and springs to those of a scene. */
        public DiaphragmPart addTo(MassSpringBuilder parts) {
            return new DiaphragmPart(this, parts);
        }
    }
}
