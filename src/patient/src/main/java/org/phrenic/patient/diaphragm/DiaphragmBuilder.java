package org.phrenic.patient.diaphragm;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.shape.ImplicitSurface;
import org.phrenic.anatomy.virtual.shape.Meridians;
import org.phrenic.anatomy.virtual.shape.RingMesh;
import org.phrenic.anatomy.virtual.shape.RootFinder;
import org.phrenic.anatomy.virtual.shape.SmoothBlends;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;
import org.phrenic.mesh.edit.Remesher;

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

    private static final double TURN_MM = 4;
    private static final double DENSE_MM = 3;
    /** Least height of the zone of apposition, mm. */
    private static final double LEAST_APPOSED_MM = 12;
    /** Depth inside the wall to which the surface counts as apposed, mm. */
    private static final double ON_WALL_MM = 3;

    private static final double START_MM = 100;

    private static final double LOWEST_RAD = Math.toRadians(-75);
    private static final double STEP_RAD = Math.toRadians(0.5);

    private final CageEnvelope cage;
    private final DomeSurface dome;
    private final InsertionLine insertion;

    private DiaphragmBuilder(Thorax body) {
        cage = new CageEnvelope(body);
        dome = new DomeSurface(body, cage, THICKNESS_MM / 2);
        insertion = dome.insertion();
    }

    /**
     * Builds a closed sheet of about the vertices of the highest resolution.
     *
     * @param body completed body, LPS, mm; its own diaphragm is ignored
     * @throws IllegalArgumentException if the body lacks ribs, spine or lungs
     */
    public static TriangleMesh build(Thorax body) {
        return build(body, Resolution.HIGH.diaphragmVertices());
    }

    /** Builds a closed sheet of about so many vertices; see {@link #build(Thorax)}. */
    public static TriangleMesh build(Thorax body, int vertices) {
        DiaphragmBuilder builder = new DiaphragmBuilder(body);
        TriangleMesh dense = builder.middleSurface();
        return TwoFacedSheet.of(Remesher.toVertexCount(dense, vertices / 2), THICKNESS_MM);
    }

    private double wall(double x, double y, double z) {
        return cage.at(x, y, z) + CLEARANCE_MM + THICKNESS_MM / 2;
    }

    @Override
    public double at(double x, double y, double z) {
        return SmoothBlends.roundIntersection(dome.at(x, y, z), wall(x, y, z), TURN_MM);
    }

    private TriangleMesh middleSurface() {
        double[][] border = new double[Meridians.AZIMUTHS][];
        for (int i = 0; i < border.length; i++) {
            double azimuth = Meridians.azimuth(i);
            border[i] = border(azimuth, insertion.height(azimuth > Math.PI ? azimuth - 2 * Math.PI : azimuth));
        }
        Meridians meridians = new Meridians(this, cage, dome.pivotZ(), true, border);
        int[] counts = RingMesh.counts(meridians, DENSE_MM, 0);
        return RingMesh.mesh(meridians, counts, true);
    }

    /**
     * The point of the surface at an azimuth and the height of the insertion, but at least {@value #LEAST_APPOSED_MM}
     * mm below the place where the roof leaves the wall, so that no lung lies between the insertion and the wall.
     */
    private double[] border(double azimuth, double height) {
        List<double[]> course = new ArrayList<>();
        double guess = START_MM;
        for (double angle = LOWEST_RAD; angle < Math.PI / 2; angle += STEP_RAD) {
            double[] p = onSurface(azimuth, angle, guess);
            guess = Vectors.distance(p, cage.point(azimuth, 0, dome.pivotZ()));
            course.add(p);
        }
        double onWall = Double.NEGATIVE_INFINITY;
        double highest = Double.NEGATIVE_INFINITY;
        boolean beside = true;
        for (double[] p : course) {
            beside &= wall(p[0], p[1], p[2]) > -ON_WALL_MM;
            onWall = beside ? Math.max(onWall, p[2]) : onWall;
            highest = Math.max(highest, p[2]);
        }
        double z = Math.min(height, (onWall > Double.NEGATIVE_INFINITY ? onWall : highest) - LEAST_APPOSED_MM);
        return course.stream().filter(p -> p[2] > z).findFirst().orElseThrow();
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
