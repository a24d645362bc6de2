package org.phrenic.scene.camera;

/**
 * A turntable camera in LPS, mm: it looks at a target from an azimuth about the patient's long axis and an elevation
 * above the axial plane, so that superior stays up. With azimuth a and elevation e the viewer stands along
 *
 * <pre>
 * d = (sin a cos e, -cos a cos e, sin e),   right r = (cos a, sin a, 0),   up u = (-sin a sin e, cos a sin e, cos e),   d = r x u
 * </pre>
 *
 * which is a rotation at the poles too: no view is mirrored, and none is undefined. Both projections show the same
 * extent at the target. Pixels count from the top left corner of the picture, x to the right and y down; the middle of
 * the first pixel is (0.5, 0.5).
 *
 * @param targetX point that is looked at and turned about, mm
 * @param targetY as above
 * @param targetZ as above
 * @param azimuthDeg 0 in front of the patient, 90 at the patient's left; within -180 to 180
 * @param elevationDeg -90 below to 90 above
 * @param heightMm height of the picture in the plane of the target, mm
 * @param orthographic parallel projection; else perspective
 * @param centreX middle of what there is to see, mm; it sets the near and far planes
 * @param centreY as above
 * @param centreZ as above
 * @param radiusMm distance from the middle within which everything lies, mm
 */
public record Camera(
        double targetX,
        double targetY,
        double targetZ,
        double azimuthDeg,
        double elevationDeg,
        double heightMm,
        boolean orthographic,
        double centreX,
        double centreY,
        double centreZ,
        double radiusMm) {
    /** Angle of view from bottom to top, degrees: that of a short telephoto lens, which flatters bodies. */
    public static final double FIELD_OF_VIEW_DEG = 25;

    private static final double TAN_HALF_FOV = Math.tan(Math.toRadians(FIELD_OF_VIEW_DEG / 2));
    /** Room left about the body, a share of the picture. */
    private static final double MARGIN = 1.1;

    private static final double MIN_HEIGHT_MM = 2;
    /** The largest height of a picture, in radii of what there is to see. */
    private static final double MAX_HEIGHT_RADII = 40;
    /** The near plane is never nearer than this share of the distance to the target: depth stays resolved. */
    private static final double MIN_NEAR_RATIO = 0.01;

    /** Bodies move beyond the box in which they rest: what is drawn reaches farther by this factor. */
    private static final double MOTION_MARGIN = 1.25;

    /** Empty scenes are looked at as if they had this radius, mm. */
    private static final double EMPTY_RADIUS_MM = 100;

    public Camera {
        azimuthDeg = Math.IEEEremainder(azimuthDeg, 360);
        elevationDeg = Math.max(-90, Math.min(90, elevationDeg));
        heightMm = Math.max(MIN_HEIGHT_MM, Math.min(MAX_HEIGHT_RADII * radiusMm, heightMm));
    }

    /**
     * Looks at the middle of a box so that all of it fits into a square picture, in perspective.
     *
     * @param bounds {@code {minX, minY, minZ, maxX, maxY, maxZ}} in mm
     */
    public static Camera of(AnatomicalView view, double[] bounds) {
        return of(view, bounds, 1);
    }

    /** As {@link #of(View, double[])} for a picture that is {@code aspect} times as wide as high. */
    public static Camera of(AnatomicalView view, double[] bounds, double aspect) {
        double[] half = new double[3];
        double[] middle = new double[3];
        for (int i = 0; i < 3; i++) {
            half[i] = (bounds[3 + i] - bounds[i]) / 2;
            middle[i] = (bounds[3 + i] + bounds[i]) / 2;
        }
        double radius = Math.sqrt(half[0] * half[0] + half[1] * half[1] + half[2] * half[2]);
        boolean seen = radius > 0 && radius < Double.POSITIVE_INFINITY;
        double size = seen ? MOTION_MARGIN * radius : EMPTY_RADIUS_MM;
        double[] at = seen ? middle : new double[3];
        Camera camera = new Camera(
                at[0],
                at[1],
                at[2],
                view.azimuthDeg(),
                view.elevationDeg(),
                2 * size,
                false,
                at[0],
                at[1],
                at[2],
                size);
        return seen ? camera.withHeight(MARGIN * camera.fittingHeight(half, aspect)) : camera;
    }

    private Camera with(
            double x, double y, double z, double azimuth, double elevation, double height, boolean parallel) {
        return new Camera(x, y, z, azimuth, elevation, height, parallel, centreX, centreY, centreZ, radiusMm);
    }

    /** Height of the picture that just holds a box about the target, in perspective. */
    private double fittingHeight(double[] half, double aspect) {
        double distance = 0;
        for (int corner = 0; corner < 8; corner++) {
            double x = (corner & 1) == 0 ? half[0] : -half[0];
            double y = (corner & 2) == 0 ? half[1] : -half[1];
            double z = (corner & 4) == 0 ? half[2] : -half[2];
            double across = Math.abs(dot(right(), x, y, z)) / aspect;
            double upward = Math.abs(dot(up(), x, y, z));
            distance = Math.max(distance, dot(towardsViewer(), x, y, z) + Math.max(across, upward) / TAN_HALF_FOV);
        }
        return 2 * distance * TAN_HALF_FOV;
    }

    /** The same camera from a standard direction. */
    public Camera withView(AnatomicalView view) {
        return with(targetX, targetY, targetZ, view.azimuthDeg(), view.elevationDeg(), heightMm, orthographic);
    }

    /** The same camera looking along a unit direction at a point. */
    public Camera lookingAlong(double[] direction, double[] at) {
        double azimuth = Math.toDegrees(Math.atan2(-direction[0], direction[1]));
        double elevation = Math.toDegrees(Math.asin(Math.max(-1, Math.min(1, -direction[2]))));
        return with(at[0], at[1], at[2], azimuth, elevation, heightMm, orthographic);
    }

    /**
     * The viewer walks about the target: {@code dAzimuthDeg} towards the patient's left when in front,
     * {@code dElevationDeg} upwards, ending at the poles.
     */
    public Camera orbit(double dAzimuthDeg, double dElevationDeg) {
        return with(
                targetX,
                targetY,
                targetZ,
                azimuthDeg + dAzimuthDeg,
                elevationDeg + dElevationDeg,
                heightMm,
                orthographic);
    }

    /**
     * The body follows a cursor that moved by these pixels (x right, y down) in a picture {@code height} pixels high.
     */
    public Camera pan(double dxPixels, double dyPixels, int height) {
        double mm = mmPerPixel(height);
        return translated(-dxPixels * mm, dyPixels * mm);
    }

    private Camera translated(double rightwards, double upwards) {
        double[] r = right();
        double[] u = up();
        return with(
                targetX + rightwards * r[0] + upwards * u[0],
                targetY + rightwards * r[1] + upwards * u[1],
                targetZ + rightwards * r[2] + upwards * u[2],
                azimuthDeg,
                elevationDeg,
                heightMm,
                orthographic);
    }

    /** Enlarges by {@code factor}; what lies under the pixel, in the plane of the target, stays there. */
    public Camera zoom(double factor, double px, double py, int width, int height) {
        Camera zoomed = withHeight(heightMm / factor);
        double change = mmPerPixel(height) - zoomed.mmPerPixel(height);
        Camera towards = translated((px - width / 2.0) * change, (height / 2.0 - py) * change);
        return towards.withHeight(zoomed.heightMm);
    }

    /** The same camera with another height of the picture, mm. */
    public Camera withHeight(double millimetres) {
        return with(targetX, targetY, targetZ, azimuthDeg, elevationDeg, millimetres, orthographic);
    }

    /** The same camera with parallel or perspective projection; the extent at the target stays. */
    public Camera withProjection(boolean parallel) {
        return with(targetX, targetY, targetZ, azimuthDeg, elevationDeg, heightMm, parallel);
    }

    /** The same camera turning about another point, mm. */
    public Camera withTarget(double x, double y, double z) {
        return with(x, y, z, azimuthDeg, elevationDeg, heightMm, orthographic);
    }

    /** Unit vector of the picture's right in LPS. */
    public double[] right() {
        double a = Math.toRadians(azimuthDeg);
        return new double[] {Math.cos(a), Math.sin(a), 0};
    }

    /** Unit vector of the picture's up in LPS. */
    public double[] up() {
        double a = Math.toRadians(azimuthDeg);
        double e = Math.toRadians(elevationDeg);
        return new double[] {-Math.sin(a) * Math.sin(e), Math.cos(a) * Math.sin(e), Math.cos(e)};
    }

    /** Unit vector from the target to the viewer in LPS. */
    public double[] towardsViewer() {
        double a = Math.toRadians(azimuthDeg);
        double e = Math.toRadians(elevationDeg);
        return new double[] {Math.sin(a) * Math.cos(e), -Math.cos(a) * Math.cos(e), Math.sin(e)};
    }

    /** Where the viewer's eye is, mm. */
    public double[] eye() {
        double[] d = towardsViewer();
        double away = distance();
        return new double[] {targetX + away * d[0], targetY + away * d[1], targetZ + away * d[2]};
    }

    /** From the eye to the target, mm. */
    public double distance() {
        return heightMm / (2 * TAN_HALF_FOV);
    }

    /** Distance from the eye to the nearest that is drawn, mm; negative behind the eye in parallel projection. */
    public double near() {
        double before = centreDepth() - radiusMm;
        return orthographic ? before : Math.max(before, MIN_NEAR_RATIO * distance());
    }

    /** Distance from the eye to the farthest that is drawn, mm. */
    public double far() {
        double behind = centreDepth() + radiusMm;
        return orthographic ? behind : Math.max(behind, 2 * near());
    }

    private double centreDepth() {
        return distance() - dot(towardsViewer(), centreX - targetX, centreY - targetY, centreZ - targetZ);
    }

    /** World to eye coordinates, a column-major 4 x 4 matrix: the eye looks along its -z. */
    public float[] viewMatrix() {
        double[] r = right();
        double[] u = up();
        double[] d = towardsViewer();
        double[] eye = eye();
        float[] m = new float[16];
        for (int column = 0; column < 3; column++) {
            m[4 * column] = (float) r[column];
            m[4 * column + 1] = (float) u[column];
            m[4 * column + 2] = (float) d[column];
        }
        m[12] = (float) -dot(r, eye[0], eye[1], eye[2]);
        m[13] = (float) -dot(u, eye[0], eye[1], eye[2]);
        m[14] = (float) -dot(d, eye[0], eye[1], eye[2]);
        m[15] = 1;
        return m;
    }

    /**
     * Eye to clip coordinates of OpenGL, a column-major 4 x 4 matrix, for a picture {@code aspect} times as wide as
     * high.
     */
    public float[] projectionMatrix(double aspect) {
        double n = near();
        double f = far();
        float[] m = new float[16];
        if (orthographic) {
            m[0] = (float) (2 / (heightMm * aspect));
            m[5] = (float) (2 / heightMm);
            m[10] = (float) (-2 / (f - n));
            m[14] = (float) (-(f + n) / (f - n));
            m[15] = 1;
        } else {
            m[0] = (float) (1 / (TAN_HALF_FOV * aspect));
            m[5] = (float) (1 / TAN_HALF_FOV);
            m[10] = (float) (-(f + n) / (f - n));
            m[11] = -1;
            m[14] = (float) (-2 * f * n / (f - n));
        }
        return m;
    }

    /** The line of sight through a pixel: where it enters what is drawn (mm), then its unit direction; six numbers. */
    public double[] ray(double px, double py, int width, int height) {
        double mm = mmPerPixel(height);
        double across = (px - width / 2.0) * mm;
        double upward = (height / 2.0 - py) * mm;
        double[] r = right();
        double[] u = up();
        double[] d = towardsViewer();
        double[] eye = eye();
        double[] ray = new double[6];
        double away = distance();
        double length = orthographic ? 1 : Math.sqrt(across * across + upward * upward + away * away);
        for (int i = 0; i < 3; i++) {
            double aside = across * r[i] + upward * u[i];
            ray[3 + i] = orthographic ? -d[i] : (aside - away * d[i]) / length;
            ray[i] = orthographic ? eye[i] + aside - near() * d[i] : eye[i] + near() * length / away * ray[3 + i];
        }
        return ray;
    }

    /**
     * Where a point is in a picture.
     *
     * @param xy receives the pixel, x right and y down
     * @return false, leaving {@code xy}, for a point behind the eye
     */
    public boolean project(double x, double y, double z, int width, int height, double[] xy) {
        double dx = x - targetX;
        double dy = y - targetY;
        double dz = z - targetZ;
        double depth = distance() - dot(towardsViewer(), dx, dy, dz);
        if (!orthographic && !(depth > 0)) {
            return false;
        }
        double pixels = height / heightMm * (orthographic ? 1 : distance() / depth);
        xy[0] = width / 2.0 + dot(right(), dx, dy, dz) * pixels;
        xy[1] = height / 2.0 - dot(up(), dx, dy, dz) * pixels;
        return true;
    }

    /** Millimetres a pixel in the plane of the target; everywhere in parallel projection. */
    public double mmPerPixel(int height) {
        return heightMm / height;
    }

    private static double dot(double[] a, double x, double y, double z) {
        return a[0] * x + a[1] * y + a[2] * z;
    }
}
