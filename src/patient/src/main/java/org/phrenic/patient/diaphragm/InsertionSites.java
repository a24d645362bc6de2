package org.phrenic.patient.diaphragm;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.StructureName;
import org.phrenic.anatomy.Thorax;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;
import org.phrenic.mesh.edit.MeshMerge;
import org.phrenic.mesh.query.TriangleTree;

/**
 * Where the diaphragm of a body inserts: the lowest {@value #XIPHOID_MM} mm of the sternum, costal cartilages 6 to 10
 * and what others have on the costal margin, the anterior {@value #END_MM} mm of ribs 7 to 10, ribs 11 and 12,
 * vertebrae L1 to L3 with their discs, and what spans the gaps between them on the inner side of the wall: the medial
 * arcuate ligament from the body of L1 over psoas to its transverse process, the lateral arcuate ligament from there
 * over quadratus lumborum to the tip of rib 12, and the slips of muscle from tip to tip up to the lowest point of the
 * costal margin.
 */
final class InsertionSites {
    static final double XIPHOID_MM = 40;
    static final double END_MM = 30;
    /** Height of the insertion above the tip of the sternum, mm. */
    static final double ABOVE_XIPHOID_MM = 12;
    /** The first level whose cartilage is part of the costal margin. */
    private static final int MARGIN_LEVEL = 7;
    /** Azimuths of a side, in degrees. */
    private static final int SECTORS = 180;
    /** Breadth of a cartilage on the costal margin, mm. */
    private static final double BREADTH_MM = 15;

    /** Share of a rib's vertices that form its tip. */
    private static final double TIP_SHARE = 0.04;

    private static final double PROCESS_MM = 6;
    /** Depth of the arcuate ligaments below the middle of the transverse process of L1, mm. */
    private static final double BELOW_PROCESS_MM = 10;
    /** Azimuth between the border of a crus and the transverse process, over psoas, rad. */
    private static final double PSOAS_RAD = Math.toRadians(6);
    /** Steps of a line on the wall, rad. */
    private static final double STEP_RAD = Math.toRadians(1);
    /** Depth of the front of a vertebral body, mm. */
    private static final double FRONT_MM = 10;
    /** Half-breadth of the crura in front of the vertebral bodies, mm. */
    private static final double CRUS_MM = 24;

    private final Thorax body;
    private final CageEnvelope cage;
    private final Map<Side, double[][]> lowest = new EnumMap<>(Side.class);

    /** @param cage envelope of the same body */
    InsertionSites(Thorax body, CageEnvelope cage) {
        this.body = body;
        this.cage = cage;
        for (Side side : Side.values()) {
            lowest.put(side, lowest(side));
        }
    }

    /** The front of a vertebral body: its lateral border on one side, its middle and its lower height, mm. */
    record Front(double[] border, double middle, double lower) {}

    /** Azimuth of a point from the back, toward one side, 0 to pi. */
    double azimuth(double[] p, Side side) {
        double a = cage.azimuth(p[0], p[1]);
        return Math.max(0, side == Side.LEFT ? a : -a);
    }

    /** The anterior end of a rib: the mean of its vertices farthest round from the back, at their lowest height. */
    Optional<double[]> tip(int level, Side side) {
        return body.find(StructureKind.RIB, level, side).map(s -> {
            TriangleMesh rib = s.mesh();
            double[] order = new double[rib.vertexCount()];
            Arrays.setAll(order, v -> azimuth(point(rib, v), side));
            double[] sorted = order.clone();
            Arrays.sort(sorted);
            double bound = sorted[(int) ((1 - TIP_SHARE) * (sorted.length - 1))];
            double[] tip = mean(
                    rib,
                    IntStream.range(0, order.length)
                            .filter(v -> order[v] >= bound)
                            .toArray());
            tip[2] = IntStream.range(0, order.length)
                    .filter(v -> order[v] >= bound)
                    .mapToDouble(rib::z)
                    .min()
                    .orElse(tip[2]);
            return tip;
        });
    }

    /** The tip of the transverse process of L1. */
    Optional<double[]> process(Side side) {
        return lumbar(1).map(mesh -> {
            double[] box = mesh.bounds();
            double x = side == Side.LEFT ? box[3] : box[0];
            return mean(
                    mesh,
                    IntStream.range(0, mesh.vertexCount())
                            .filter(v -> Math.abs(mesh.x(v) - x) < PROCESS_MM)
                            .toArray());
        });
    }

    /** The front of a lumbar vertebra, 1 to 3. */
    Optional<Front> front(int level, Side side) {
        return lumbar(level).map(mesh -> {
            double foremost = mesh.bounds()[1] + FRONT_MM;
            int[] front = IntStream.range(0, mesh.vertexCount())
                    .filter(v -> mesh.y(v) < foremost)
                    .toArray();
            double[] middle = mean(mesh, front);
            double sign = side == Side.LEFT ? 1 : -1;
            double half = IntStream.of(front)
                    .mapToDouble(v -> sign * (mesh.x(v) - middle[0]))
                    .max()
                    .orElse(CRUS_MM);
            middle[0] += sign * Math.min(CRUS_MM, half);
            double lower = IntStream.of(front).mapToDouble(mesh::z).min().orElse(middle[2]);
            return new Front(middle, middle[2], lower);
        });
    }

    /**
     * The course of the insertion on the wall from the border of the crus to the lowest point of the costal margin:
     * azimuths from the back, increasing, and heights. From the transverse process on it is the lower hull of the tips
     * of ribs 12 and 11 and the margin.
     *
     * @param margin lowest vertices of cartilages and ribs 7 to 10, from back to front
     */
    List<double[]> lateral(Side side, List<double[]> margin) {
        List<double[]> points = new ArrayList<>();
        Optional<double[]> crus = front(1, side).map(f -> new double[] {azimuth(f.border(), side), f.lower()});
        double first = crus.map(c -> c[0] + PSOAS_RAD).orElse(0.0);
        process(side)
                .ifPresent(p -> points.add(new double[] {Math.max(first, azimuth(p, side)), p[2] - BELOW_PROCESS_MM}));
        for (int level : new int[] {12, 11}) {
            tip(level, side).ifPresent(t -> addBeyond(points, azimuth(t, side), t[2]));
        }
        double lowest = margin.stream().mapToDouble(p -> p[2]).min().orElse(0);
        for (double[] p : margin) {
            addBeyond(points, azimuth(p, side), p[2]);
            if (p[2] <= lowest) {
                break;
            }
        }
        List<double[]> hull = new ArrayList<>();
        for (double[] p : points) {
            while (hull.size() > 1 && !isBelow(hull.get(hull.size() - 1), hull.get(hull.size() - 2), p)) {
                hull.remove(hull.size() - 1);
            }
            hull.add(p);
        }
        crus.ifPresent(c -> hull.add(0, c));
        return hull;
    }

    private static void addBeyond(List<double[]> points, double azimuth, double z) {
        if (points.isEmpty() || azimuth > points.get(points.size() - 1)[0]) {
            points.add(new double[] {azimuth, z});
        }
    }

    private static boolean isBelow(double[] p, double[] before, double[] after) {
        double t = (p[0] - before[0]) / (after[0] - before[0]);
        return p[1] < before[1] + t * (after[1] - before[1]);
    }

    /** The costal margin: {@link #lowest(Side)} from the back to the front. */
    List<double[]> margin(Side side) {
        return Arrays.stream(lowest.get(side)).filter(p -> p != null).toList();
    }

    /**
     * Lowest vertex of cartilages and ribs 7 to 10 of a side in each degree of azimuth from the back; null where there
     * is none. In many scans, cartilages 5 to 7 are one piece in front, under any of their numbers: what of those above
     * the seventh lies below the insertion on the sternum belongs to the margin as well.
     */
    private double[][] lowest(Side side) {
        double[][] lowest = new double[SECTORS][];
        double sternum = xiphoid().map(z -> z + ABOVE_XIPHOID_MM).orElse(Double.NEGATIVE_INFINITY);
        for (Structure s : body.structures()) {
            boolean cartilage = s.kind() == StructureKind.COSTAL_CARTILAGE;
            boolean above = s.level() < MARGIN_LEVEL;
            boolean chosen =
                    s.side() == side && s.level() <= 10 && (cartilage || (!above && s.kind() == StructureKind.RIB));
            double bound = above ? sternum : Double.POSITIVE_INFINITY;
            for (int v = 0; chosen && v < s.mesh().vertexCount(); v++) {
                double[] p = point(s.mesh(), v);
                int sector = sector(p, side);
                boolean lower = p[2] < (lowest[sector] == null ? bound : Math.min(bound, lowest[sector][2]));
                lowest[sector] = lower ? p : lowest[sector];
            }
        }
        return lowest;
    }

    private int sector(double[] p, Side side) {
        return Math.min(SECTORS - 1, (int) Math.toDegrees(azimuth(p, side)));
    }

    /** The vertices of a cartilage above the sixth that lie on the costal margin. */
    private IntPredicate onMargin(TriangleMesh cartilage, Side side) {
        double[][] margins = lowest.get(side);
        return v -> {
            double[] p = point(cartilage, v);
            double[] margin = margins[sector(p, side)];
            return margin != null && p[2] < margin[2] + BREADTH_MM;
        };
    }

    /** Height of the lower end of the sternum, mm. */
    Optional<Double> xiphoid() {
        return merged(StructureKind.STERNUM).map(sternum -> sternum.bounds()[2]);
    }

    /** All sites, to measure distances. */
    TriangleTree tree() {
        List<TriangleMesh> sites = new ArrayList<>();
        merged(StructureKind.STERNUM).ifPresent(sternum -> {
            double top = sternum.bounds()[2] + XIPHOID_MM;
            sites.add(part(sternum, t -> sternum.z(t) < top));
        });
        for (Structure s : body.structures()) {
            boolean crus = (s.kind() == StructureKind.VERTEBRA || s.kind() == StructureKind.DISC)
                    && s.level() >= StructureName.FIRST_LUMBAR
                    && s.level() <= StructureName.FIRST_LUMBAR + 2;
            boolean cartilage = s.kind() == StructureKind.COSTAL_CARTILAGE && s.level() >= MARGIN_LEVEL - 1;
            boolean rib = s.kind() == StructureKind.RIB && s.level() >= 11;
            if (crus || cartilage || rib) {
                sites.add(s.mesh());
            } else if (s.kind() == StructureKind.COSTAL_CARTILAGE) {
                sites.add(part(s.mesh(), onMargin(s.mesh(), s.side())));
            } else if (s.kind() == StructureKind.RIB && s.level() >= 7) {
                tip(s.level(), s.side()).ifPresent(end -> sites.add(part(s.mesh(), near(s.mesh(), end))));
            }
        }
        for (Side side : List.of(Side.RIGHT, Side.LEFT)) {
            List<double[]> course = lateral(side, margin(side));
            for (int i = 1; i < course.size(); i++) {
                addLine(course.get(i - 1), course.get(i), side, sites);
            }
        }
        return new TriangleTree(MeshMerge.merge(sites));
    }

    private static IntPredicate near(TriangleMesh mesh, double[] end) {
        return v -> Vectors.distance(point(mesh, v), end) < END_MM;
    }

    /** Adds a line on the wall as triangles without area. */
    private void addLine(double[] from, double[] to, Side side, List<TriangleMesh> sites) {
        int steps = (int) Math.ceil((to[0] - from[0]) / STEP_RAD);
        double[] last = onWall(from[0], from[1], side);
        for (int k = 1; k <= steps; k++) {
            double t = (double) k / steps;
            double[] next = onWall(from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1]), side);
            sites.add(new TriangleMesh(
                    new double[] {last[0], last[1], last[2], next[0], next[1], next[2], next[0], next[1], next[2]},
                    new int[] {0, 1, 2}));
            last = next;
        }
    }

    private double[] onWall(double turn, double z, Side side) {
        double azimuth = side == Side.LEFT ? turn : -turn;
        return cage.point(azimuth, cage.radius(azimuth, z), z);
    }

    private static TriangleMesh part(TriangleMesh mesh, IntPredicate chosen) {
        int[] t = mesh.triangles();
        return new TriangleMesh(
                mesh.positions(),
                IntStream.range(0, mesh.triangleCount())
                        .filter(i -> chosen.test(t[3 * i]) && chosen.test(t[3 * i + 1]) && chosen.test(t[3 * i + 2]))
                        .flatMap(i -> IntStream.of(t[3 * i], t[3 * i + 1], t[3 * i + 2]))
                        .toArray());
    }

    private Optional<TriangleMesh> lumbar(int level) {
        return body.find(StructureKind.VERTEBRA, StructureName.FIRST_LUMBAR - 1 + level, Side.MIDLINE)
                .map(Structure::mesh);
    }

    private Optional<TriangleMesh> merged(StructureKind kind) {
        List<TriangleMesh> meshes =
                body.structuresOf(kind).stream().map(Structure::mesh).toList();
        return meshes.isEmpty() ? Optional.empty() : Optional.of(MeshMerge.merge(meshes));
    }

    private static double[] point(TriangleMesh mesh, int v) {
        return new double[] {mesh.x(v), mesh.y(v), mesh.z(v)};
    }

    private static double[] mean(TriangleMesh mesh, int[] vertices) {
        double[] mean = new double[3];
        for (int v : vertices) {
            mean[0] += mesh.x(v) / vertices.length;
            mean[1] += mesh.y(v) / vertices.length;
            mean[2] += mesh.z(v) / vertices.length;
        }
        return mean;
    }
}
