package org.phrenic.model.organ;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.OpposingVertices;
import org.phrenic.anatomy.cage.MovingChestWall;
import org.phrenic.engine.constraint.NonInversionPairs;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.mesh.CotangentWeights;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;

/**
 * The diaphragm as nodes and springs of a scene: springs along its edges, which contract along the fibres in muscle,
 * struts across its thickness, and rigid links in the tendon.
 *
 * <p>It also lists the nodes that are attached to bone, the nodes that slide on the chest wall, and the faces under
 * abdominal pressure.
 */
public final class DiaphragmPart {
    /**
     * Largest distance to the opposing vertex across the sheet, mm. The sheet is 2 to 5 mm thick; segmented sheets are
     * up to four times thicker.
     */
    private static final double REACH_MM = 20;

    private static final int STRUTS = 2;
    /** Limits of the number of equilateral triangles that an edge counts for; slivers would pass them. */
    private static final double LEAST_TRIANGLES = 0.4;

    private static final double MOST_TRIANGLES = 8;
    /** Inset of the abdominal face from the wall, as a share of the thickness: at rest it is free. */
    private static final double INSET_SHARE = 0.97;

    private static final double MIDLINE_MM = 20;
    private static final double FRONT_MM = 50;
    /** Distance from the wall at rest, mm, within which the abdominal face belongs to the zone of apposition. */
    private static final double APPOSED_MM = 15;
    /**
     * Stiffness per unit of area of the tissue at the origin of the crura. It yields 1 to 2 mm to a muscle stress of
     * some kPa in a sheet of some mm.
     */
    private static final double CRURAL_KPA_PER_MM = 1;

    /** Diagonal of the box of a sheet up to which it counts as one of usual size, mm. */
    private static final double USUAL_SIZE_MM = 380;

    public final Diaphragm diaphragm;
    public final int firstNode;
    public final List<OpposingVertices.Pair> links;
    /**
     * Share of each vertex that belongs to the tendinous origin of the crura, 0 to 1. It reduces the contraction there.
     */
    private final double[] cruralShare;

    /** Scene nodes at the origin of the crura, without those that are fixed to bone. */
    public final int[] cruralNodes;
    /**
     * Stiffness with which each of {@code cruralNodes} is attached to the vertebrae, N/m. It is proportional to the
     * node's area, so it does not depend on the mesh resolution.
     */
    public final double[] cruralStiffnesses;

    private final SheetStruts struts;
    private final FaceOrder faceOrder;
    /**
     * For each edge of the sheet, then each strut: contractile share along the fibres (0 in the tendon), position from
     * right (0) to left (1) across the midline, and from back (0) to front (1).
     */
    private double[] fibreShare;

    private double[] leftShare;
    private double[] frontShare;
    /** For each edge of the sheet: part of its length in the tendon, 0 to 1. */
    private double[] tendonShare;

    /**
     * Tissue of a diaphragm.
     *
     * @param tendonRatio stiffness of the tendon as a multiple of the muscle's
     * @param linksPerNode number of rigid links per tendon node
     * @param struts whether struts cross the thickness and the faces are kept from inverting
     * @param crura share of each vertex that belongs to the tendinous origin of the crura, 0 to 1
     * @param leftOverRight ratio of activation, left to right
     * @param frontOverBack ratio of activation, front to back
     */
    @SuppressWarnings("ArrayRecordComponent") // read once
    public record Tissue(
            TissueLaw law,
            double tendonRatio,
            int linksPerNode,
            boolean struts,
            double[] crura,
            double leftOverRight,
            double frontOverBack) {}

    /** Adds the nodes and springs of a diaphragm to a scene. */
    public DiaphragmPart(Diaphragm diaphragm, Tissue from, MassSpringBuilder parts) {
        double[] origin = from.crura;
        TissueLaw law = from.law;
        double tendonRatio = from.tendonRatio;
        this.diaphragm = diaphragm;
        this.cruralShare = origin;
        TriangleMesh sheet = diaphragm.sheet();
        double[] muscle = law.masses(sheet, 1);
        double[] tendon = law.masses(sheet, tendonRatio);
        Arrays.setAll(muscle, i -> diaphragm.isTendon(i) ? tendon[i] : muscle[i]);
        firstNode = parts.addNodes(sheet, muscle);
        int[] crural = IntStream.range(0, origin.length)
                .filter(i -> origin[i] > 0 && !diaphragm.isInserted(i))
                .toArray();
        double[] areas = MeshMeasure.vertexAreas(sheet);
        cruralNodes = MassSpringBuilder.offset(crural, firstNode);
        cruralStiffnesses = IntStream.of(crural)
                .mapToDouble(i -> CRURAL_KPA_PER_MM * origin[i] * areas[i])
                .toArray();
        OpposingVertices across = OpposingVertices.of(diaphragm, REACH_MM);
        List<OpposingVertices.Pair> crossing = from.struts ? across.nearestPairs(STRUTS) : List.of();
        struts = new SheetStruts(diaphragm, crossing, law.edgeStiffness(2, 1));
        addSprings(parts.sheetSprings, from, crossing);
        links = across.greedyMatching(diaphragm::isTendon, from.linksPerNode);
        faceOrder = new FaceOrder(diaphragm, from.struts ? across.greedyMatching(i -> isFreeMuscle(i), 1) : List.of());
    }

    /**
     * Size of the sheet relative to a usual one, at least 1. The time constants of its slow modes grow with the size.
     * Up to 380 mm across its box, somewhat more than in the virtual bodies and the scanned man, a sheet is a usual
     * one.
     */
    public double relativeSize() {
        double[] box = diaphragm.sheet().bounds();
        double squared = 0;
        for (int axis = 0; axis < 3; axis++) {
            squared += (box[axis + 3] - box[axis]) * (box[axis + 3] - box[axis]);
        }
        return Math.max(1, Math.sqrt(squared) / USUAL_SIZE_MM);
    }

    private boolean isFreeMuscle(int vertex) {
        return !diaphragm.isTendon(vertex) && !diaphragm.isInserted(vertex);
    }

    private void addSprings(SpringList springs, Tissue from, List<OpposingVertices.Pair> across) {
        MeshTopology topology = diaphragm.topology();
        double[] p = diaphragm.sheet().positions();
        double[] box = diaphragm.upright().bounds();
        int edges = topology.edgeCount();
        fibreShare = new double[edges + across.size()];
        leftShare = new double[edges + across.size()];
        frontShare = new double[edges + across.size()];
        tendonShare = new double[edges];
        MuscleStrain strain = new MuscleStrain(diaphragm);
        for (int e = 0; e < edges; e++) {
            int a = topology.edges()[2 * e];
            int b = topology.edges()[2 * e + 1];
            double share = diaphragm.tendonShare(a, b);
            tendonShare[e] = from.struts || share == 1 ? share : 0;
            placeSpring(e, box, a, b, strain.alongEdge(e) * (1 - tendonShare[e]));
        }
        double[] stiffness = edgeStiffnesses(from);
        double[] carried = struts.carriedShares(topology, stiffness);
        for (int e = 0; e < edges; e++) {
            int a = topology.edges()[2 * e];
            int b = topology.edges()[2 * e + 1];
            double rest = 1 - 0.5 * (carried[a] + carried[b]);
            double contractile = contractileShare(e, from.leftOverRight, from.frontOverBack);
            springs.addEdge(p, firstNode, a, b, rest * stiffness[e], contractile);
        }
        for (int i = 0; i < across.size(); i++) {
            OpposingVertices.Pair pair = across.get(i);
            placeSpring(edges + i, box, pair.a(), pair.b(), strain.alongStrut(pair.a(), pair.b()));
            double contractile = contractileShare(edges + i, from.leftOverRight, from.frontOverBack);
            springs.addEdge(p, firstNode, pair.a(), pair.b(), struts.stiffness(pair), contractile);
        }
    }

    /** Stiffness of each edge of the sheet if edges alone carried it, N/m. */
    private double[] edgeStiffnesses(Tissue from) {
        double[] weights = CotangentWeights.of(diaphragm.sheet(), diaphragm.topology());
        double[] stiffness = new double[weights.length];
        for (int e = 0; e < stiffness.length; e++) {
            double triangles = Math.max(LEAST_TRIANGLES, Math.min(MOST_TRIANGLES, 2 * Math.sqrt(3) * weights[e]));
            stiffness[e] = from.law.edgeStiffness(triangles, inSeries(tendonShare[e], from.tendonRatio));
        }
        return stiffness;
    }

    /** Sets the contractile share of a spring, less where it lies in the crura, and where it lies in the sheet. */
    private void placeSpring(int spring, double[] box, int a, int b, double share) {
        TriangleMesh sheet = diaphragm.upright();
        double origin = 0.5 * (cruralShare[a] + cruralShare[b]);
        fibreShare[spring] = share * (1 - origin);
        double middle = 0.5 * (box[0] + box[3]);
        double middleY = 0.5 * (box[1] + box[4]);
        leftShare[spring] = smoothShare(0.5 * (sheet.x(a) + sheet.x(b)) - middle, MIDLINE_MM);
        frontShare[spring] = smoothShare(middleY - 0.5 * (sheet.y(a) + sheet.y(b)), FRONT_MM);
    }

    /**
     * Share of the muscle activation at a position left (+) or right (-) of the midline: 1 on the stronger side, with a
     * smooth transition across the midline.
     */
    private static double driveShare(double leftness, double leftOverRight) {
        double right = Math.min(1, 1 / leftOverRight);
        double left = Math.min(1, leftOverRight);
        return right + (left - right) * leftness * leftness * (3 - 2 * leftness);
    }

    private static double smoothShare(double x, double halfWidth) {
        return Math.max(0, Math.min(1, 0.5 + 0.5 * x / halfWidth));
    }

    /** Left share of each triangle under abdominal pressure, 0 to 1, smooth across the midline. */
    public double[] abdominalLeftShares() {
        TriangleMesh sheet = diaphragm.upright();
        double[] box = sheet.bounds();
        double middle = 0.5 * (box[0] + box[3]);
        int[] t = sheet.triangles();
        return IntStream.range(0, sheet.triangleCount())
                .filter(i -> !diaphragm.isThoracicTriangle(i))
                .mapToDouble(i -> (sheet.x(t[3 * i]) + sheet.x(t[3 * i + 1]) + sheet.x(t[3 * i + 2])) / 3 - middle)
                // An infinite ratio leaves no share on the right, so the result is the smooth step to the left.
                .map(x -> driveShare(smoothShare(x, MIDLINE_MM), Double.POSITIVE_INFINITY))
                .toArray();
    }

    /** Share of the activation that shortens a spring of the sheet: its edges, then its struts. */
    public double contractileShare(int spring, double leftOverRight, double frontOverBack) {
        return spring < fibreShare.length
                ? fibreShare[spring]
                        * driveShare(leftShare[spring], leftOverRight)
                        * driveShare(frontShare[spring], frontOverBack)
                : 0;
    }

    /** Stiffness relative to muscle of an edge whose part in the tendon is in series with its part in muscle. */
    static double inSeries(double tendonShare, double tendonRatio) {
        return tendonShare == 1 ? tendonRatio : 1 / (tendonShare / tendonRatio + 1 - tendonShare);
    }

    /**
     * Factor of the stiffness of a spring of the sheet, in spring order, if the tendon's stiffness over the muscle's
     * changes.
     */
    public double tendonFactor(int spring, double ratio, double assembledRatio) {
        double share = spring < tendonShare.length ? tendonShare[spring] : 0;
        return inSeries(share, ratio) / inSeries(share, assembledRatio);
    }

    /** Contractile share along the fibres of each edge of the sheet, 0 in the tendon. */
    public double[] fibreShares() {
        return Arrays.copyOf(fibreShare, tendonShare.length);
    }

    /** Vertices of the sheet that are attached to bone. */
    public int[] insertedVertices() {
        return IntStream.range(0, diaphragm.sheet().vertexCount())
                .filter(diaphragm::isInserted)
                .toArray();
    }

    /**
     * Vertices of the sheet in contact with the chest wall: the thoracic face of the muscle, and the abdominal face in
     * the zone of apposition, but for the crura in the middle of the chest, which no chest wall is near. The abdominal
     * face is included because a strut keeps its length but does not stop the two faces from passing through each
     * other.
     */
    public int[] slidingVertices(MovingChestWall wall) {
        TriangleMesh s = diaphragm.sheet();
        return IntStream.range(0, s.vertexCount())
                .filter(i -> isFreeMuscle(i) && wall.isAwayFromAxis(s.x(i), s.y(i)))
                .filter(i -> diaphragm.isThoracic(i) || wall.depth(s.x(i), s.y(i), s.z(i)) < APPOSED_MM)
                .toArray();
    }

    /** Inset from the wall at which contact stops a vertex, mm. */
    public double wallInset(int vertex) {
        return diaphragm.isThoracic(vertex) ? 0 : INSET_SHARE * struts.thickness(vertex);
    }

    /** Constraint that keeps the thoracic face outside the abdominal face in muscle. */
    public NonInversionPairs orderedPairs(NodeLayout layout, double refresh) {
        return faceOrder.constraint(layout, firstNode, refresh);
    }

    /**
     * Vertices on which an action line can act: all that are not attached to bone. A line passes through the dome,
     * tendon and muscle alike.
     */
    public int[] freeVertices() {
        return IntStream.range(0, diaphragm.sheet().vertexCount())
                .filter(i -> !diaphragm.isInserted(i))
                .toArray();
    }

    /** Position x, y of the action line of a side (-1 right, 1 left), mm. */
    public double[] actionLinePosition(int side) {
        double[] box = diaphragm.upright().bounds();
        double[] upright = {
            0.5 * (box[0] + box[3]) + side * 0.25 * (box[3] - box[0]), 0.5 * (box[1] + box[4]), 0.5 * (box[2] + box[5])
        };
        return Arrays.copyOf(diaphragm.frame().toScan(upright), 2);
    }

    /** Triangles under abdominal pressure, as scene nodes. */
    public int[] abdominalTriangles() {
        int[] t = diaphragm.sheet().triangles();
        return IntStream.range(0, diaphragm.sheet().triangleCount())
                .filter(i -> !diaphragm.isThoracicTriangle(i))
                .flatMap(i -> IntStream.range(3 * i, 3 * i + 3))
                .map(i -> firstNode + t[i])
                .toArray();
    }
}
