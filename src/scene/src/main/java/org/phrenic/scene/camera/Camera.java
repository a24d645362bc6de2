package org.phrenic.scene.camera;

import java.util.Optional;
import java.util.stream.Stream;
import org.joml.Matrix3d;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * A turntable camera in LPS, mm. It looks at a target from an azimuth a about the patient's long axis and an elevation
 * e above the axial plane. The superior direction points up in the picture. The unit vector d from the target to the
 * viewer is
 *
 * <pre>
 * d = (sin a cos e, -cos a cos e, sin e),   right r = (cos a, sin a, 0),   up u = d x r
 * </pre>
 *
 * No view is mirrored, and the axes are also defined at the poles. Both projections show the same extent at the target.
 * Pixel coordinates start at the top left corner of the picture, x to the right and y down; the centre of the first
 * pixel is (0.5, 0.5).
 *
 * @param target point that the camera looks at and rotates about, mm
 * @param azimuthDeg azimuth, degrees, -180 to 180: 0 in front of the patient, 90 at the patient's left
 * @param elevationDeg elevation, degrees, -90 (from below) to 90 (from above)
 * @param heightMm height of the picture in the plane of the target, mm
 * @param orthographic whether the projection is parallel instead of perspective
 * @param centre centre of the scene, mm; sets the near and far planes
 * @param radiusMm radius of a sphere about the centre that contains the scene, mm
 */
public record Camera(
        Vector3dc target,
        double azimuthDeg,
        double elevationDeg,
        double heightMm,
        boolean orthographic,
        Vector3dc centre,
        double radiusMm) {
    /** Vertical field of view, degrees; that of a short telephoto lens. */
    public static final double FIELD_OF_VIEW_DEG = 25;

    private static final double TAN_HALF_FOV = Math.tan(Math.toRadians(FIELD_OF_VIEW_DEG / 2));
    /** Factor by which the visible extent exceeds the body. */
    private static final double MARGIN = 1.1;

    private static final double MIN_HEIGHT_MM = 2;
    /** Maximum picture height, in radii of the scene. */
    private static final double MAX_HEIGHT_RADII = 40;
    /** Minimum near distance as a fraction of the target distance, which preserves depth buffer resolution. */
    private static final double MIN_NEAR_RATIO = 0.01;
    /** Factor that enlarges the scene radius, because bodies move out of their box at rest. */
    private static final double MOTION_MARGIN = 1.25;
    /** Angles that differ by less are the same but for rounding, degrees. */
    private static final double SAME_VIEW_DEG = 1e-6;
    /** Radius assumed for an empty scene, mm. */
    private static final double EMPTY_RADIUS_MM = 100;

    public Camera {
        azimuthDeg = Math.IEEEremainder(azimuthDeg, 360);
        elevationDeg = Math.max(-90, Math.min(90, elevationDeg));
        heightMm = Math.max(MIN_HEIGHT_MM, Math.min(MAX_HEIGHT_RADII * radiusMm, heightMm));
    }

    /**
     * A perspective camera that looks at the centre of a box and fits it into a square picture.
     *
     * @param bounds {@code {minX, minY, minZ, maxX, maxY, maxZ}} in mm
     */
    public static Camera of(AnatomicalView view, double[] bounds) {
        return of(view, bounds, 1);
    }

    /** Like {@link #of(AnatomicalView, double[])}, for a picture with {@code aspect} = width / height. */
    public static Camera of(AnatomicalView view, double[] bounds, double aspect) {
        Vector3d low = new Vector3d(bounds[0], bounds[1], bounds[2]);
        Vector3d high = new Vector3d(bounds[3], bounds[4], bounds[5]);
        Vector3d half = high.sub(low, new Vector3d()).mul(0.5);
        boolean seen = half.length() > 0 && half.isFinite();
        double radius = seen ? MOTION_MARGIN * half.length() : EMPTY_RADIUS_MM;
        Vector3d centre = seen ? low.add(high).mul(0.5) : new Vector3d();
        Camera camera = new Camera(centre, view.azimuthDeg(), view.elevationDeg(), 2 * radius, false, centre, radius);
        return seen ? camera.withHeight(MARGIN * camera.fittingHeight(half, aspect)) : camera;
    }

    /** Copy that fits a box around the target into a picture, as it is seen from this side. */
    public Camera fitting(double[] bounds, double aspect) {
        Vector3d half = new Vector3d(bounds[3] - bounds[0], bounds[4] - bounds[1], bounds[5] - bounds[2]).mul(0.5);
        return half.length() > 0 && half.isFinite() ? withHeight(MARGIN * fittingHeight(half, aspect)) : this;
    }

    /** Smallest picture height, mm, that contains a box around the target in perspective. */
    private double fittingHeight(Vector3d half, double aspect) {
        Matrix4d rotation = rotation();
        double distance = 0;
        for (int corner = 0; corner < 8; corner++) {
            Vector3d at = new Vector3d(
                    (corner & 1) == 0 ? half.x : -half.x,
                    (corner & 2) == 0 ? half.y : -half.y,
                    (corner & 4) == 0 ? half.z : -half.z);
            rotation.transformPosition(at);
            distance = Math.max(distance, at.z + Math.max(Math.abs(at.x) / aspect, Math.abs(at.y)) / TAN_HALF_FOV);
        }
        return 2 * distance * TAN_HALF_FOV;
    }

    private Camera with(Vector3dc lookedAt, double azimuth, double elevation) {
        return new Camera(lookedAt, azimuth, elevation, heightMm, orthographic, centre, radiusMm);
    }

    /** Copy with a standard direction of view. */
    public Camera withView(AnatomicalView view) {
        return with(target, view.azimuthDeg(), view.elevationDeg());
    }

    /** The standard view that the camera has, whatever it looks at; empty if it is turned away from all of them. */
    public Optional<AnatomicalView> view() {
        return Stream.of(AnatomicalView.values()).filter(this::looksAs).findFirst();
    }

    private boolean looksAs(AnatomicalView view) {
        double turned = Math.IEEEremainder(azimuthDeg - view.azimuthDeg(), 360);
        return Math.max(Math.abs(turned), Math.abs(elevationDeg - view.elevationDeg())) < SAME_VIEW_DEG;
    }

    /** Copy that looks along a unit direction at a point, x y z each. */
    public Camera lookingAlong(double[] direction, double[] at) {
        double azimuth = Math.toDegrees(Math.atan2(-direction[0], direction[1]));
        double elevation = Math.toDegrees(Math.asin(Math.max(-1, Math.min(1, -direction[2]))));
        return with(new Vector3d(at), azimuth, elevation);
    }

    /**
     * Rotates about the target. From the front, a positive azimuth moves towards the patient's left. The elevation is
     * limited to the poles.
     */
    public Camera orbit(double dAzimuthDeg, double dElevationDeg) {
        return with(target, azimuthDeg + dAzimuthDeg, elevationDeg + dElevationDeg);
    }

    /**
     * Pans so that the body follows a cursor movement (x right, y down, pixels) in a picture {@code height} pixels
     * high.
     */
    public Camera pan(double dxPixels, double dyPixels, int height) {
        double mm = mmPerPixel(height);
        return translated(-dxPixels * mm, dyPixels * mm);
    }

    private Camera translated(double rightwards, double upwards) {
        Vector3d moved = new Vector3d(target).fma(rightwards, right()).fma(upwards, up());
        return with(moved, azimuthDeg, elevationDeg);
    }

    /** Magnifies by {@code factor}. The point under the pixel, in the plane of the target, stays under it. */
    public Camera zoom(double factor, double px, double py, int width, int height) {
        Camera zoomed = withHeight(heightMm / factor);
        double change = mmPerPixel(height) - zoomed.mmPerPixel(height);
        return translated((px - width / 2.0) * change, (height / 2.0 - py) * change)
                .withHeight(zoomed.heightMm);
    }

    /** Copy with another picture height in the plane of the target, mm. */
    public Camera withHeight(double millimetres) {
        return new Camera(target, azimuthDeg, elevationDeg, millimetres, orthographic, centre, radiusMm);
    }

    /** Copy with parallel or perspective projection and the same extent at the target. */
    public Camera withProjection(boolean parallel) {
        return new Camera(target, azimuthDeg, elevationDeg, heightMm, parallel, centre, radiusMm);
    }

    public Camera withTarget(double x, double y, double z) {
        return with(new Vector3d(x, y, z), azimuthDeg, elevationDeg);
    }

    /** Unit vector to the right of the picture, LPS. */
    public Vector3d right() {
        double a = Math.toRadians(azimuthDeg);
        return new Vector3d(Math.cos(a), Math.sin(a), 0);
    }

    /** Unit vector to the top of the picture, LPS. */
    public Vector3d up() {
        return towardsViewer().cross(right());
    }

    /** Unit vector from the target to the viewer, LPS. */
    public Vector3d towardsViewer() {
        double a = Math.toRadians(azimuthDeg);
        double e = Math.toRadians(elevationDeg);
        return new Vector3d(Math.sin(a) * Math.cos(e), -Math.cos(a) * Math.cos(e), Math.sin(e));
    }

    /** Rotation from world to eye directions; the rows are right, up and towards the viewer. */
    public Matrix4d rotation() {
        return new Matrix4d(new Matrix3d(right(), up(), towardsViewer()).transpose());
    }

    public Vector3d eye() {
        return towardsViewer().mul(distance()).add(target);
    }

    /** Distance from the eye to the target, mm. */
    public double distance() {
        return heightMm / (2 * TAN_HALF_FOV);
    }

    /** Distance from the eye to the near plane, mm; may be negative in parallel projection (plane behind the eye). */
    public double near() {
        double near = centreDepth() - radiusMm;
        return orthographic ? near : Math.max(near, MIN_NEAR_RATIO * distance());
    }

    /** Distance from the eye to the far plane, mm. */
    public double far() {
        double far = centreDepth() + radiusMm;
        return orthographic ? far : Math.max(far, 2 * near());
    }

    private double centreDepth() {
        return distance() - towardsViewer().dot(centre.sub(target, new Vector3d()));
    }

    /** World to eye coordinates. The eye looks along -z. */
    public Matrix4d viewMatrix() {
        return rotation().translate(eye().negate());
    }

    /** Eye to OpenGL clip coordinates for a picture with {@code aspect} = width / height. */
    public Matrix4d projectionMatrix(double aspect) {
        return orthographic
                ? new Matrix4d().setOrthoSymmetric(heightMm * aspect, heightMm, near(), far())
                : new Matrix4d().setPerspective(Math.toRadians(FIELD_OF_VIEW_DEG), aspect, near(), far());
    }

    /** The line of sight through a pixel: intersection with the near plane (x y z, mm), then unit direction (x y z). */
    public double[] ray(double px, double py, int width, int height) {
        double mm = mmPerPixel(height);
        Vector3d inPlane = right().mul((px - width / 2.0) * mm).fma((height / 2.0 - py) * mm, up());
        Vector3d forward = towardsViewer().negate();
        Vector3d direction = orthographic
                ? forward
                : forward.mul(distance(), new Vector3d()).add(inPlane).normalize();
        Vector3d origin = orthographic
                ? eye().add(inPlane).fma(near(), forward)
                : eye().fma(near() / direction.dot(forward), direction);
        return new double[] {origin.x, origin.y, origin.z, direction.x, direction.y, direction.z};
    }

    /**
     * Projects a point to pixel coordinates.
     *
     * @param xy receives the pixel coordinates, x right and y down
     * @return false for a point behind the eye, which leaves {@code xy} unchanged
     */
    public boolean project(double x, double y, double z, int width, int height, double[] xy) {
        double mm = mmPerPixelAt(x, y, z, height);
        if (!(mm > 0)) {
            return false;
        }
        Vector3d at = rotation().transformPosition(new Vector3d(x, y, z).sub(target));
        xy[0] = width / 2.0 + at.x / mm;
        xy[1] = height / 2.0 - at.y / mm;
        return true;
    }

    /** Millimetres per pixel at the depth of a point; not positive for a point behind the eye. */
    public double mmPerPixelAt(double x, double y, double z, int height) {
        double depth = distance() - towardsViewer().dot(new Vector3d(x, y, z).sub(target));
        return mmPerPixel(height) * (orthographic ? 1 : depth / distance());
    }

    /** Millimetres per pixel in the plane of the target; the same at every depth in parallel projection. */
    public double mmPerPixel(int height) {
        return heightMm / height;
    }
}
