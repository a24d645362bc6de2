package org.phrenic.patient.diaphragm;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.shape.ImplicitSurface;
import org.phrenic.anatomy.virtual.shape.Meridians;
import org.phrenic.anatomy.virtual.shape.RingMesh;
import org.phrenic.anatomy.virtual.shape.RootFinder;
import org.phrenic.anatomy.virtual.shape.SmoothBlends;
import org.phrenic.anatomy.virtual.shape.TwoFacedSheet;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;
import org.phrenic.mesh.edit.MeshMerge;
import org.phrenic.mesh.edit.Remesher;
import org.phrenic.mesh.query.SelfIntersections;
import org.phrenic.mesh.query.TriangleTree;

/**
 * Builds the diaphragm of a body from its bones and organs. The middle surface is the border of the region below the
 * roof ({@link DomeSurface}) and inside the chest wall ({@link CageEnvelope}, inset by the pleura and half the sheet),
 * down to the insertion ({@link InsertionLine}). The sheet has two faces at the stated thickness that meet at the
 * insertion, and lies inside the cage by construction.
 */
public final class DiaphragmBuilder implements ImplicitSurface {
    /** Thickness of the sheet, mm: muscle, 2 to 5 (physiology C1). */
    public static final double THICKNESS_MM = 3;
    /** Distance from the bones' inner side to the sheet, mm: pleura, fascia and innermost intercostal muscle. */
    public static final double CLEARANCE_MM = 1;

    /**
     * Smoothing lengths of the roof, mm, and for each the depths of its pivot, taken in turn; see {@link #choose}. From
     * a deeper pivot, rays pass by a spur of a lung that would hide the base beyond it.
     */
    private static final double[] SMOOTHING_MM = {5, 7, 10, 14, 20, 28, 40};

    private static final double[] PIVOT_DEPTHS = {0.7, 0.9};

    /** Smoothing length up to which sheets that leave the wall are compared, mm; a smoother roof cuts into organs. */
    private static final double COMPARED_MM = 10;

    private static final double TURN_MM = 4;
    private static final double DENSE_MM = 3;
    /** Least height of the zone of apposition below a lung, mm. */
    private static final double BELOW_LUNG_MM = 12;
    /** Least height of the zone of apposition elsewhere, mm. */
    private static final double LEAST_APPOSED_MM = 2;
    /** Distance from the place where the roof leaves the wall within which a lung counts as above it, mm. */
    private static final double LUNG_REACH_MM = 10;
    /** Depth inside the wall to which the surface counts as apposed, mm. */
    private static final double ON_WALL_MM = 3;

    private static final int SMOOTHING = 2;
    /** Distance between neighbouring points of a course that shows a hidden part, mm. */
    private static final double HIDDEN_MM = 6;

    private static final double START_MM = 100;

    private static final double LOWEST_RAD = Math.toRadians(-75);
    private static final double STEP_RAD = Math.toRadians(0.5);

    private final CageEnvelope cage;
    private final DomeSurface dome;
    private final InsertionLine insertion;
    private final TriangleTree lungs;

    private DiaphragmBuilder(Thorax body, CageEnvelope cage, DomeSurface.Shape shape) {
        this.cage = cage;
        dome = new DomeSurface(body, cage, THICKNESS_MM / 2, shape);
        insertion = dome.insertion();
        lungs = new TriangleTree(MeshMerge.merge(body.structuresOf(StructureKind.LUNG).stream()
                .map(Structure::mesh)
                .toList()));
    }

    /**
     * Builds a closed sheet of about the vertices of the highest resolution.
     *
     * @param body completed body, LPS, mm; its own diaphragm is ignored
     * @throws IllegalArgumentException if the body lacks ribs, spine or lungs, or its sheet would pass through itself
     */
    public static TriangleMesh build(Thorax body) {
        return build(body, Optional.empty(), Resolution.HIGH.diaphragmVertices());
    }

    /** Builds a closed sheet of about so many vertices; see {@link #build(Thorax)}. */
    public static TriangleMesh build(Thorax body, int vertices) {
        return build(body, Optional.empty(), vertices);
    }

    /**
     * Builds a closed sheet of about so many vertices; see {@link #build(Thorax)}.
     *
     * @param parted as {@link BreathLevel#parted}
     */
    static TriangleMesh build(Thorax body, Optional<Side> parted, int vertices) {
        return build(body, new CageEnvelope(body), parted, body::isInScan, vertices);
    }

    /**
     * The same inside a known envelope.
     *
     * @param stays which organs stay where they are and do not yield to the sheet
     */
    static TriangleMesh build(
            Thorax body, CageEnvelope cage, Optional<Side> parted, Predicate<Structure> stays, int vertices) {
        return choose(
                        shape -> new DiaphragmBuilder(body, cage, shape).sheet(vertices),
                        parted,
                        sheet -> SheetQuality.liesOnWall(body, cage, sheet),
                        sheet -> SheetQuality.of(body, cage, sheet, stays).excess())
                .orElseThrow(() -> new IllegalArgumentException(
                        "between the lungs and the organs below, its sheet would pass through itself"));
    }

    /**
     * The first sheet if it lies on the wall, else of the next ones the first without excess, or the one of least
     * excess, or the first that there is; all of those that do not pass through themselves.
     *
     * @param build builds the sheet of a roof
     * @param liesOnWall whether a sheet keeps to the wall and has no slivers
     * @param excess what the measures of a sheet are beyond their limits
     */
    static Optional<TriangleMesh> choose(
            Function<DomeSurface.Shape, TriangleMesh> build,
            Optional<Side> parted,
            Predicate<TriangleMesh> liesOnWall,
            ToDoubleFunction<TriangleMesh> excess) {
        Optional<TriangleMesh> best = Optional.empty();
        double least = Double.POSITIVE_INFINITY;
        for (double smoothing : SMOOTHING_MM) {
            if (best.isPresent() && smoothing > COMPARED_MM) {
                break;
            }
            for (double depth : PIVOT_DEPTHS) {
                DomeSurface.Shape shape = new DomeSurface.Shape(smoothing, depth, parted);
                TriangleMesh sheet = build.apply(shape);
                if (SelfIntersections.count(sheet) > 0) {
                    continue;
                }
                if (shape.equals(first(parted)) && liesOnWall.test(sheet)) {
                    return Optional.of(sheet);
                }
                double beyond = excess.applyAsDouble(sheet);
                if (beyond == 0) {
                    return Optional.of(sheet);
                }
                if (beyond < least) {
                    best = Optional.of(sheet);
                    least = beyond;
                }
            }
        }
        return best;
    }

    private TriangleMesh sheet(int vertices) {
        return TwoFacedSheet.of(Remesher.toVertexCount(middleSurface(), vertices / 2), THICKNESS_MM);
    }

    /** The roof of the diaphragm as it is tried first. */
    static DomeSurface roof(Thorax body, CageEnvelope cage) {
        return new DomeSurface(body, cage, THICKNESS_MM / 2, first(Optional.empty()));
    }

    private static DomeSurface.Shape first(Optional<Side> parted) {
        return new DomeSurface.Shape(SMOOTHING_MM[0], PIVOT_DEPTHS[0], parted);
    }

    private double wall(double x, double y, double z) {
        return cage.at(x, y, z) + CLEARANCE_MM + THICKNESS_MM / 2;
    }

    @Override
    public double at(double x, double y, double z) {
        return SmoothBlends.roundIntersection(dome.at(x, y, z), wall(x, y, z), TURN_MM);
    }

    private TriangleMesh middleSurface() {
        double[][] border = border();
        Meridians meridians = new Meridians(this, cage, dome.pivotZ(), true, border);
        int[] counts = RingMesh.counts(meridians, DENSE_MM, 0);
        return RingMesh.mesh(meridians, counts, true);
    }

    /**
     * The points of the surface at the height of the insertion, but at least {@value #LEAST_APPOSED_MM} mm below the
     * places where the roof leaves the wall, {@value #BELOW_LUNG_MM} mm below a lung, so that no lung lies between the
     * insertion and the wall. Where the roof lowers the border, it is smoothed over {@value #SMOOTHING} azimuths.
     */
    private double[][] border() {
        double[][][] course = new double[Meridians.AZIMUTHS][][];
        double[] height = new double[course.length];
        double[] lowered = new double[course.length];
        TriangleTree.Hit hit = new TriangleTree.Hit();
        for (int i = 0; i < course.length; i++) {
            double azimuth = Meridians.azimuth(i);
            course[i] = course(azimuth);
            height[i] = insertion.height(azimuth > Math.PI ? azimuth - 2 * Math.PI : azimuth);
            double[] top = onWall(course[i]);
            boolean lung = lungs.isWithin(top[0], top[1], top[2], LUNG_REACH_MM, hit);
            lowered[i] = Math.max(0, height[i] - top[2] + (lung ? BELOW_LUNG_MM : LEAST_APPOSED_MM));
        }
        double[] drop = smoothed(lowered);
        double[][] border = new double[course.length][];
        for (int i = 0; i < border.length; i++) {
            border[i] = atHeight(course[i], height[i] - drop[i]);
        }
        return border;
    }

    /** The greatest value within {@value #SMOOTHING} azimuths, averaged over as many. */
    private static double[] smoothed(double[] values) {
        double[] most = new double[values.length];
        double[] mean = new double[values.length];
        for (int i = 0; i < values.length; i++) {
            for (int k = -SMOOTHING; k <= SMOOTHING; k++) {
                most[i] = Math.max(most[i], values[Math.floorMod(i + k, values.length)]);
            }
        }
        for (int i = 0; i < values.length; i++) {
            for (int k = -SMOOTHING; k <= SMOOTHING; k++) {
                mean[i] += most[Math.floorMod(i + k, values.length)] / (2 * SMOOTHING + 1);
            }
        }
        return mean;
    }

    /** The surface at an azimuth, from below to above. */
    private double[][] course(double azimuth) {
        List<double[]> course = new ArrayList<>();
        double guess = START_MM;
        for (double angle = LOWEST_RAD; angle < Math.PI / 2; angle += STEP_RAD) {
            double[] p = onSurface(azimuth, angle, guess);
            guess = Vectors.distance(p, cage.point(azimuth, 0, dome.pivotZ()));
            course.add(p);
        }
        return course.toArray(double[][]::new);
    }

    /** The point where a course leaves the wall; its highest point if it never lies on the wall. */
    private double[] onWall(double[][] course) {
        double[] onWall = {0, 0, Double.NEGATIVE_INFINITY};
        double[] highest = course[0];
        boolean beside = true;
        for (double[] p : course) {
            beside &= wall(p[0], p[1], p[2]) > -ON_WALL_MM;
            onWall = beside && p[2] > onWall[2] ? p : onWall;
            highest = p[2] > highest[2] ? p : highest;
        }
        return onWall[2] > Double.NEGATIVE_INFINITY ? onWall : highest;
    }

    /**
     * The first point of a course at a height; its first point above the height where the spine hides the surface below
     * from the pivot.
     */
    private static double[] atHeight(double[][] course, double z) {
        int i = 1;
        while (i < course.length - 1 && course[i][2] <= z) {
            i++;
        }
        if (Vectors.distance(course[i - 1], course[i]) > HIDDEN_MM) {
            return course[i];
        }
        double t = (z - course[i - 1][2]) / Math.max(1e-9, course[i][2] - course[i - 1][2]);
        return Vectors.lerp(course[i - 1], course[i], Math.max(0, Math.min(1, t)));
    }

    /** Point of the surface along the ray from the pivot at an azimuth and an elevation. */
    private double[] onSurface(double azimuth, double elevation, double guess) {
        double cos = StrictMath.cos(elevation);
        double sin = StrictMath.sin(elevation);
        double r = RootFinder.firstOutward(
                s -> {
                    double[] p = cage.point(azimuth, s * cos, dome.pivotZ() + s * sin);
                    return at(p[0], p[1], p[2]);
                },
                guess);
        return cage.point(azimuth, r * cos, dome.pivotZ() + r * sin);
    }
}
