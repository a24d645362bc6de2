package org.phrenic.scene;

import java.awt.geom.Path2D;
import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.phrenic.access.plan.NeedleState;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.Vectors;
import org.phrenic.mesh.query.PlaneCut;
import org.phrenic.scene.annotate.PatientOrientation;
import org.phrenic.scene.style.SurfaceMaterial;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * A plane section of the body and the needle. Coordinates are in mm in the plane, x to the right and y up, with the
 * origin at the centre of the picture.
 *
 * @param parts sections of the structures, in painting order
 * @param entry entry point of the needle
 * @param tip tip of the needle
 * @param end end point of the planned path
 * @param target centre of the target
 * @param targetRadiusMm radius of the target, mm
 * @param targetPlaneDistanceMm signed distance of the target's centre from the plane, mm
 * @param right anatomical letters of the direction to the right, such as "L"
 * @param up anatomical letters of the upward direction
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
    /** The section of a structure, and its colour as {@code 0xRRGGBB}. */
    public record Part(StructureKind kind, Path2D outline, int rgb) {}

    /** Painting order of the kinds of structures. */
    static final List<StructureKind> PAINTING_ORDER = List.of(
            StructureKind.SKIN,
            StructureKind.MUSCLE,
            StructureKind.OTHER,
            StructureKind.PLEURA,
            StructureKind.LUNG,
            StructureKind.LIVER,
            StructureKind.ORGAN,
            StructureKind.VESSEL,
            StructureKind.LESION,
            StructureKind.BONE,
            StructureKind.DIAPHRAGM,
            StructureKind.COSTAL_CARTILAGE,
            StructureKind.STERNUM,
            StructureKind.DISC,
            StructureKind.VERTEBRA,
            StructureKind.RIB);

    /** Minimum length of a vector that can be normalized. */
    private static final double MIN_LENGTH = 1e-6;

    /**
     * Section in the plane through the needle that is closest to axial, about the middle between entry and target. It
     * is viewed from below, as an axial slice: the patient's right is at the left and the front at the top.
     */
    public static BodySection alongNeedle(List<Surface> surfaces, Frame frame, NeedleState state) {
        double[] needle = Vectors.normalize(Vectors.subtract(state.tip(), state.hub()));
        double[] normal = Vectors.cross(needle, perpendicular(needle, new double[] {0, 0, 1}));
        double[] right = projectedOntoPlane(new double[] {1, 0, 0}, normal);
        double[] up = Vectors.cross(normal, right);
        if (up[1] > 0) {
            up = Vectors.of(-up[0], -up[1], -up[2]);
        }
        double[] entry = state.entry().orElse(state.tip());
        double[] middle = Vectors.lerp(entry, state.target(), 0.5);
        double beside = Vectors.dot(Vectors.subtract(middle, entry), normal);
        return cut(surfaces, frame, state, Vectors.addScaled(middle, normal, -beside), right, up);
    }

    /**
     * Section perpendicular to the needle, viewed from the hub. The plane passes through the tip, or through the target
     * if the needle is not placed.
     */
    public static BodySection acrossNeedle(List<Surface> surfaces, Frame frame, NeedleState state) {
        double[] needle = Vectors.normalize(Vectors.subtract(state.tip(), state.hub()));
        double[] up = projectedOntoPlane(new double[] {0, 0, 1}, needle);
        double[] at = state.placed() ? state.tip() : state.target();
        return cut(surfaces, frame, state, at, Vectors.cross(needle, up), up);
    }

    /** Unit vector perpendicular to both vectors; the x axis if they are parallel. */
    private static double[] perpendicular(double[] a, double[] b) {
        double[] c = Vectors.cross(a, b);
        return Vectors.length(c) > MIN_LENGTH ? Vectors.normalize(c) : new double[] {1, 0, 0};
    }

    /** Unit vector of a direction projected onto the plane with the given normal. */
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
                        int rgb =
                                SurfaceMaterial.of(kind, s.name()).appearance().packedRgb();
                        parts.add(new Part(kind, outline(curves), rgb));
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
                PatientOrientation.letters(new Vector3d(right)),
                PatientOrientation.letters(new Vector3d(up)));
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

    /** Radius of the disc in which the plane cuts the target, mm; 0 if the plane misses the target. */
    public double targetSectionRadiusMm() {
        double squared = targetRadiusMm * targetRadiusMm - targetPlaneDistanceMm * targetPlaneDistanceMm;
        return squared > 0 ? Math.sqrt(squared) : 0;
    }
}
