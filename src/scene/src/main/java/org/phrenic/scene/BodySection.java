package org.phrenic.scene;

import java.awt.geom.Path2D;
import java.util.ArrayList;
import java.util.List;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.Vectors;
import org.phrenic.mesh.query.PlaneCut;
import org.phrenic.scene.annotate.PatientOrientation;
import org.phrenic.scene.style.StructureLabels;
import org.phrenic.scene.style.SurfaceMaterial;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * The body cut by a plane, in mm of the plane, x to the right and y upwards, from the middle of the picture.
 *
 * @param parts what is cut, from the outside in
 * @param entry of the needle
 * @param tip of the needle
 * @param end of the way that it is to go
 * @param target its middle
 * @param targetRadiusMm its radius
 * @param targetPlaneDistanceMm how far its middle lies from the plane
 * @param right letters of what lies to the right: "L"
 * @param up letters of what lies upwards
 */
public record BodySection(
        List<Part> parts,
        double[] entry,
        double[] tip,
        double[] end,
        double[] target,
        double targetRadiusMm,
        double targetPlaneDistanceMm,
        String right,
        String up) {
    /**
     * A structure that is cut.
     *
     * @param kind what it is
     * @param name for people
     * @param outline its curves
     * @param rgb colour as {@code 0xRRGGBB}
     */
    public record Part(StructureKind kind, String name, Path2D outline, int rgb) {}

    /** The order in which structures are painted. */
    private static final List<StructureKind> PAINTING_ORDER = List.of(
            StructureKind.SKIN,
            StructureKind.OTHER,
            StructureKind.LUNG,
            StructureKind.LIVER,
            StructureKind.DIAPHRAGM,
            StructureKind.COSTAL_CARTILAGE,
            StructureKind.STERNUM,
            StructureKind.DISC,
            StructureKind.VERTEBRA,
            StructureKind.RIB);

    /** Directions flatter than this count as having none across. */
    private static final double MIN_LENGTH = 1e-6;

    /**
     * The plane that holds the needle and is as level as it can be, seen from below as an axial slice is: the patient's
     * right at the left, the front at the top.
     */
    public static BodySection alongNeedle(List<Surface> surfaces, Frame frame, NeedleState state) {
        double[] needle = Vectors.normalize(Vectors.subtract(state.tip(), state.hub()));
        double[] level = perpendicular(needle, new double[] {0, 0, 1});
        double[] normal = Vectors.cross(needle, level);
        double[] x = new double[] {1, 0, 0};
        double[] right = projectedOntoPlane(x, normal);
        double[] up = Vectors.cross(normal, right);
        if (up[1] > 0) {
            up = Vectors.of(-up[0], -up[1], -up[2]);
        }
        return cut(surfaces, frame, state, middle(state), right, up);
    }

    /**
     * The plane through the tip at a right angle to the needle, seen from the hub: what the needle will meet next;
     * through the target while there is no needle in the body.
     */
    public static BodySection acrossNeedle(List<Surface> surfaces, Frame frame, NeedleState state) {
        double[] needle = Vectors.normalize(Vectors.subtract(state.tip(), state.hub()));
        double[] up = projectedOntoPlane(new double[] {0, 0, 1}, needle);
        double[] at = state.placed() ? state.tip() : state.target();
        return cut(surfaces, frame, state, at, Vectors.cross(needle, up), up);
    }

    private static double[] middle(NeedleState state) {
        double[] entry = state.entry().orElse(state.tip());
        return Vectors.lerp(entry, state.target(), 0.5);
    }

    /** A unit vector at right angles to both. */
    private static double[] perpendicular(double[] a, double[] b) {
        double[] c = Vectors.cross(a, b);
        return Vectors.length(c) > MIN_LENGTH ? Vectors.normalize(c) : new double[] {1, 0, 0};
    }

    /** A direction without its part along a normal. */
    private static double[] projectedOntoPlane(double[] wanted, double[] normal) {
        double[] flat = Vectors.addScaled(wanted, normal, -Vectors.dot(wanted, normal));
        return Vectors.length(flat) > MIN_LENGTH
                ? Vectors.normalize(flat)
                : Vectors.orthonormalize(new double[] {0, -1, 0}, normal);
    }

    private static BodySection cut(
            List<Surface> surfaces, Frame frame, NeedleState state, double[] origin, double[] right, double[] up) {
        PlaneCut plane = new PlaneCut(origin, right, up);
        List<Part> parts = new ArrayList<>();
        for (StructureKind kind : PAINTING_ORDER) {
            for (int i = 0; i < surfaces.size(); i++) {
                Surface s = surfaces.get(i);
                if (s.kind() == kind) {
                    double[] at = new double[s.rest().positions().length];
                    frame.writePositions(s, i, at);
                    List<double[]> curves = plane.intersect(at, s.rest().triangles());
                    if (!curves.isEmpty()) {
                        float[] rgb = SurfaceMaterial.of(kind).appearance().rgb();
                        int colour = Math.round(255 * rgb[0]) << 16
                                | Math.round(255 * rgb[1]) << 8
                                | Math.round(255 * rgb[2]);
                        parts.add(new Part(kind, StructureLabels.of(s), outline(curves), colour));
                    }
                }
            }
        }
        double[] entry = state.entry().orElse(state.tip());
        double[] needle = Vectors.normalize(Vectors.subtract(state.tip(), state.hub()));
        return new BodySection(
                List.copyOf(parts),
                plane.project(entry),
                plane.project(state.tip()),
                plane.project(Vectors.addScaled(entry, needle, state.aimedDepthMm())),
                plane.project(state.target()),
                state.targetRadiusMm(),
                plane.signedDistance(state.target()),
                PatientOrientation.letters(right[0], right[1], right[2]),
                PatientOrientation.letters(up[0], up[1], up[2]));
    }

    private static Path2D outline(List<double[]> curves) {
        Path2D path = new Path2D.Double(Path2D.WIND_EVEN_ODD);
        for (double[] curve : curves) {
            path.moveTo(curve[0], curve[1]);
            for (int i = 2; i < curve.length; i += 2) {
                path.lineTo(curve[i], curve[i + 1]);
            }
        }
        return path;
    }

    /** Radius of the disc in which the plane cuts the target, mm; 0 where it does not. */
    public double targetSectionRadiusMm() {
        double squared = targetRadiusMm * targetRadiusMm - targetPlaneDistanceMm * targetPlaneDistanceMm;
        return squared > 0 ? Math.sqrt(squared) : 0;
    }
}
