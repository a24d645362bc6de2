package org.phrenic.patient.diaphragm;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.MedianFrame;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.engine.math.OrderStatistic;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshQuality;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.MeshMerge;
import org.phrenic.mesh.query.SelfIntersections;
import org.phrenic.mesh.query.TriangleTree;

/**
 * Quality of the diaphragm of a body: a list of measures with their limits.
 *
 * <ul>
 *   <li>Outside the cage: distance of vertices beyond {@link CageEnvelope}.
 *   <li>Insertion: distance of the border of the thoracic face from where it inserts: lower end of the sternum, costal
 *       cartilages, ends of ribs 7 to 10, ribs 11 and 12, arcuate ligaments, vertebrae L1 to L3.
 *   <li>Wall: distance of the apposed vertices of the thoracic face from the envelope.
 *   <li>Wrong side: organ vertices more than 3 mm beyond the middle of the sheet.
 *   <li>Triangles: self-intersections, smallest angle, longest over shortest edge.
 * </ul>
 */
public record SheetQuality(List<Measure> measures, Optional<String> refusal) {
    /** Vertices farther outside the envelope are counted, mm. */
    private static final double OUTSIDE_MM = 3;
    /** Share of vertices outside the cage, or greatest distance, beyond which a sheet is refused. */
    private static final double MOST_OUTSIDE_PERCENT = 25;

    private static final double FARTHEST_OUTSIDE_MM = 60;
    /** Share of organ vertices on the wrong side beyond which a sheet is refused. */
    private static final double MOST_THROUGH_PERCENT = 15;

    private static final double LEAST_DOME_MM = 20;
    /** Smallest angle of the triangles of a good sheet. */
    static final double LEAST_ANGLE_DEG = 5;

    /** Reach of a ray from the thoracic face within which a lung shows that the sheet is not apposed, mm. */
    private static final double APPOSED_REACH_MM = 40;

    private static final double HORIZONTAL = 0.7;
    /** Azimuth from the back beyond which the sheet lies on ribs and not on the spine, rad. */
    private static final double BESIDE_SPINE = Math.toRadians(40);

    /**
     * One measure.
     *
     * @param key name in a report
     * @param what words for a table
     * @param unit mm, %, degrees or empty
     * @param limit limit that a good sheet keeps
     * @param atMost whether the limit is an upper one
     */
    public record Measure(String key, String what, double value, String unit, double limit, boolean atMost) {
        /** Whether the value keeps its limit. */
        public boolean isGood() {
            return atMost ? value <= limit : value >= limit;
        }
    }

    public SheetQuality {
        measures = List.copyOf(measures);
    }

    /**
     * Measures the sheet of a body in LPS, along and across its median plane.
     *
     * @return empty if the body has no diaphragm, no ribs or no lower thoracic vertebrae
     */
    public static Optional<SheetQuality> of(Thorax scanned) {
        Thorax body = MedianFrame.of(scanned).toFrame(scanned);
        List<Structure> sheets = body.structuresOf(StructureKind.DIAPHRAGM);
        if (sheets.isEmpty() || sheets.get(0).mesh().triangleCount() == 0) {
            return Optional.empty();
        }
        try {
            return Optional.of(of(body, new CageEnvelope(body)));
        } catch (IllegalArgumentException e) {
            return Optional.empty();
        }
    }

    /** Measures the sheet of a body whose envelope is known. */
    static SheetQuality of(Thorax body, CageEnvelope cage) {
        TriangleMesh shells = body.structuresOf(StructureKind.DIAPHRAGM).get(0).mesh();
        return of(body, cage, Diaphragm.sheetAmong(shells).orElse(shells), organ -> true);
    }

    /**
     * Measures a sheet in place of that of a body whose envelope is known.
     *
     * @param counts which organs count
     */
    static SheetQuality of(Thorax body, CageEnvelope cage, TriangleMesh sheet, Predicate<Structure> counts) {
        return new Measuring(body, sheet, cage).result(counts);
    }

    /**
     * Whether a sheet keeps the limits of its smallest angle, its insertion and its apposition. What it does not tell:
     * the cage, inside which a sheet is built, and organs, on which its roof lies as far as it can.
     */
    static boolean liesOnWall(Thorax body, CageEnvelope cage, TriangleMesh sheet) {
        return MeshQuality.of(sheet).smallestAngleDeg() >= LEAST_ANGLE_DEG
                && new Measuring(body, sheet, cage).ofWall().stream().allMatch(Measure::isGood);
    }

    /** Sum of what measures are beyond their limits, relative to these; that of a limit of 0 does not count. */
    double excess() {
        return measures.stream()
                .filter(m -> !m.isGood() && m.limit() > 0)
                .mapToDouble(m -> (m.atMost() ? m.value() / m.limit() : m.limit() / Math.max(m.value(), 1e-3)) - 1)
                .sum();
    }

    /** One sentence for the measures beyond their limits; empty if all are good. */
    public Optional<String> warning() {
        String bad = measures.stream()
                .filter(m -> !m.isGood())
                .map(m -> Numbers.format(
                        "%s %.3g%s (limit %.3g)",
                        m.what(), m.value(), m.unit().isEmpty() ? "" : " " + m.unit(), m.limit()))
                .collect(Collectors.joining(", "));
        return bad.isEmpty() ? Optional.empty() : Optional.of("the diaphragm exceeds its limits: " + bad);
    }

    /** The value of a measure by its key. */
    public double value(String key) {
        return measures.stream()
                .filter(m -> m.key().equals(key))
                .findFirst()
                .orElseThrow()
                .value();
    }

    /** Working state of one measurement. */
    private static final class Measuring {
        private final Thorax body;
        private final TriangleMesh sheet;
        private final CageEnvelope cage;
        private final Diaphragm diaphragm;
        private final List<Measure> measures = new ArrayList<>();

        Measuring(Thorax body, TriangleMesh sheet, CageEnvelope cage) {
            this.body = body;
            this.sheet = sheet;
            this.cage = cage;
            diaphragm = Diaphragm.withTrefoilTendon(sheet);
        }

        SheetQuality result(Predicate<Structure> counts) {
            double[] outside = IntStream.range(0, sheet.vertexCount())
                    .mapToDouble(v -> Math.max(0, cage.at(sheet.x(v), sheet.y(v), sheet.z(v))))
                    .toArray();
            double share =
                    100.0 * Arrays.stream(outside).filter(d -> d > OUTSIDE_MM).count() / outside.length;
            add("outside_cage_maximum_mm", "outside the cage, greatest", greatest(outside), "mm", 3);
            add("outside_cage_percentile_95_mm", "outside the cage, 95 %", percentile95(outside), "mm", 2);
            add("outside_cage_share_percent", "vertices more than 3 mm outside", share, "%", 0);
            ofWall();
            double through = addOrgans(counts);
            MeshQuality quality = MeshQuality.of(sheet);
            add("self_intersections", "self-intersections", SelfIntersections.count(sheet), "", 0);
            measures.add(new Measure(
                    "first_percentile_angle_deg",
                    "angles of triangles, first percentile",
                    quality.firstPercentileAngleDeg(),
                    "degrees",
                    15,
                    false));
            measures.add(new Measure(
                    "smallest_angle_deg",
                    "smallest angle",
                    quality.smallestAngleDeg(),
                    "degrees",
                    LEAST_ANGLE_DEG,
                    false));
            add("edge_ratio", "longest over shortest edge", quality.edgeRatio(), "", 10);
            return new SheetQuality(measures, refusal(share, greatest(outside), through));
        }

        /** Adds the measures of insertion and apposition; returns the measures so far. */
        List<Measure> ofWall() {
            double[] insertion = insertionDistances();
            add("insertion_to_margin_mean_mm", "insertion to the costal margin, mean", mean(insertion), "mm", 5);
            add(
                    "insertion_to_margin_percentile_95_mm",
                    "insertion to the costal margin, 95 %",
                    percentile95(insertion),
                    "mm",
                    8);
            double[] apposed = apposedDistances();
            add("apposed_to_wall_mean_mm", "apposed part to the wall, mean", mean(apposed), "mm", 5);
            add("apposed_to_wall_percentile_95_mm", "apposed part to the wall, 95 %", percentile95(apposed), "mm", 10);
            return measures;
        }

        private void add(String key, String what, double value, String unit, double limit) {
            measures.add(new Measure(key, what, value, unit, limit, true));
        }

        /** Adds the measures of organs; returns the share of their vertices on the wrong side, per cent. */
        private double addOrgans(Predicate<Structure> counts) {
            OrganSides thoracic = new OrganSides(
                    diaphragm,
                    true,
                    ContactingOrgans.thoracic(body).stream().filter(counts).toList());
            OrganSides abdominal = new OrganSides(
                    diaphragm,
                    false,
                    ContactingOrgans.abdominal(body).stream().filter(counts).toList());
            double share = 100.0
                    * (thoracic.count() + abdominal.count())
                    / Math.max(1, thoracic.vertices() + abdominal.vertices());
            add("organ_vertices_through_percent", "organ vertices more than 3 mm through", share, "%", 0);
            add(
                    "organs_through_maximum_mm",
                    "organs through the sheet, greatest",
                    Math.max(thoracic.greatestMm(), abdominal.greatestMm()),
                    "mm",
                    OrganSides.THROUGH_MM);
            return share;
        }

        /** Distances of the border of the thoracic face, which lies on the wall, from the nearest site of insertion. */
        private double[] insertionDistances() {
            TriangleTree tree = new InsertionSites(body, cage).tree();
            TriangleTree.Hit hit = new TriangleTree.Hit();
            return IntStream.range(0, sheet.vertexCount())
                    .filter(v -> diaphragm.isInserted(v) && diaphragm.isThoracic(v))
                    .mapToDouble(v -> tree.closest(sheet.x(v), sheet.y(v), sheet.z(v), hit)
                            ? Math.sqrt(hit.distanceSquared)
                            : Double.POSITIVE_INFINITY)
                    .toArray();
        }

        /** Distances from the envelope of the thoracic face where it looks at ribs and no lung lies between. */
        private double[] apposedDistances() {
            List<TriangleMesh> lungs = body.structuresOf(StructureKind.LUNG).stream()
                    .map(Structure::mesh)
                    .toList();
            TriangleTree tree = new TriangleTree(MeshMerge.merge(lungs));
            TriangleTree.Hit hit = new TriangleTree.Hit();
            double[] normals = MeshMeasure.vertexNormals(sheet);
            return IntStream.range(0, sheet.vertexCount())
                    .filter(v -> diaphragm.isThoracic(v) && !diaphragm.isInserted(v))
                    .filter(v -> {
                        double dx = sheet.x(v) - cage.x(sheet.z(v));
                        double dy = sheet.y(v) - cage.y(sheet.z(v));
                        double out = (normals[3 * v] * dx + normals[3 * v + 1] * dy) / StrictMath.hypot(dx, dy);
                        boolean lung = tree.nearestAlongRay(
                                        sheet.x(v),
                                        sheet.y(v),
                                        sheet.z(v),
                                        normals[3 * v],
                                        normals[3 * v + 1],
                                        normals[3 * v + 2],
                                        hit)
                                && hit.rayParameter < APPOSED_REACH_MM;
                        return out > HORIZONTAL && !lung && Math.abs(StrictMath.atan2(dx, dy)) > BESIDE_SPINE;
                    })
                    .mapToDouble(v -> Math.abs(cage.at(sheet.x(v), sheet.y(v), sheet.z(v))))
                    .toArray();
        }

        private Optional<String> refusal(double outsidePercent, double farthest, double throughPercent) {
            MeshTopology topology = diaphragm.topology();
            if (!topology.isClosed() || !topology.isManifold()) {
                return Optional.of("the diaphragm is not a closed surface, expected a sheet of two faces");
            }
            if (outsidePercent > MOST_OUTSIDE_PERCENT || farthest > FARTHEST_OUTSIDE_MM) {
                return Optional.of(Numbers.format(
                        "the diaphragm leaves the rib cage by up to %.0f mm, with %.0f %% of its vertices; bones and"
                                + " lungs of the scan do not belong together, or the file states its spacing wrongly",
                        farthest, outsidePercent));
            }
            if (throughPercent > MOST_THROUGH_PERCENT) {
                return Optional.of(Numbers.format(
                        "%.0f %% of the vertices of lungs and organs lie on the wrong side of the diaphragm; the scan"
                                + " shows too little of them, bones and organs do not belong together, or the file"
                                + " states its spacing wrongly",
                        throughPercent));
            }
            double margin = IntStream.range(0, sheet.vertexCount())
                    .filter(diaphragm::isInserted)
                    .mapToDouble(sheet::z)
                    .average()
                    .orElse(Double.NaN);
            double height = sheet.bounds()[5] - margin;
            return height >= LEAST_DOME_MM
                    ? Optional.empty()
                    : Optional.of(Numbers.format(
                            "the dome of the diaphragm rises %.0f mm above its insertion, expected %.0f mm or more",
                            height, LEAST_DOME_MM));
        }

        private static double greatest(double[] values) {
            return DoubleStream.of(values).max().orElse(0);
        }

        private static double mean(double[] values) {
            return DoubleStream.of(values).average().orElse(0);
        }

        private static double percentile95(double[] values) {
            return OrderStatistic.atShare(values, 0.95);
        }
    }
}
