package org.phrenic.patient.diaphragm;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.shape.ImplicitSurface;
import org.phrenic.anatomy.virtual.shape.RootFinder;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.MeshMerge;
import org.phrenic.mesh.query.TriangleTree;

/**
 * The roof of the diaphragm: a smooth distance ρ from a pivot in the abdomen, over all directions up to
 * {@value #WIDEST_DEG} degrees from the vertical, between the bases of the lungs and the organs below. As an implicit
 * function it is negative below the roof.
 *
 * <p>A ray from the pivot meets the base of a lung at ρ_t and leaves the highest abdominal organ at ρ_a. Where both are
 * known and near, the roof is in the middle; where the lung alone is near, the roof lies on its base; elsewhere, as
 * under the heart, it lies on the abdominal organ. The thin plate through these values ({@link ThinPlateGrid}) fills
 * the rest, and is held above every abdominal organ and below every lung where it would run through one.
 */
final class DomeSurface implements ImplicitSurface {
    /** Directions: the polar angle from the vertical and the azimuth as polar coordinates of a square grid. */
    private static final double WIDEST_DEG = 152;

    private static final double STEP_DEG = 2;
    private static final int HALF = (int) (WIDEST_DEG / STEP_DEG);
    private static final int SIDE = 2 * HALF;
    private static final int ROUNDS = 6;
    /** A lung farther than this above an abdominal organ alone determines the roof, mm. */
    private static final double NEAR_MM = 8;
    /** Weight of an abdominal organ where no lung is. */
    private static final double ORGAN_WEIGHT = 0.3;

    private static final double LEAST_COSINE = 0.35;
    private static final double ROOF_COSINE = 0.7;
    /** Distance by which the roof leaves the wall below the lungs, mm. */
    private static final double BEYOND_WALL_MM = 3;

    /** Least depth of the insertion below the top of the lungs' bases, mm. */
    private static final double BELOW_TOP_MM = 15;

    private static final double ABOVE_INSERTION_MM = 5;
    /** Cosine of the polar angle of {@value #WIDEST_DEG} degrees less a cell; there is no roof beyond. */
    private static final double DOWNWARD = StrictMath.cos(Math.toRadians(WIDEST_DEG - 4));

    private static final double FAR_MM = 400;

    private final double[] pivot;
    private final double[] rho;
    private final double halfThickness;
    private final InsertionLine insertion;

    /**
     * How a roof is made.
     *
     * @param smoothingMm length L of the thin plate, mm
     * @param pivotDepth depth of the pivot below the highest base of a lung, in half-breadths of the cage
     * @param parted side of the lung that does not lie on the diaphragm, if the other one tells
     */
    record Shape(double smoothingMm, double pivotDepth, Optional<Side> parted) {}

    DomeSurface(Thorax body, CageEnvelope cage, double halfThickness, Shape shape) {
        this.halfThickness = halfThickness;
        List<LungBase> bases = UnequalBases.of(body, shape.parted());
        if (bases.isEmpty()) {
            throw new IllegalArgumentException("the body has no lungs");
        }
        double top = bases.stream().mapToDouble(LungBase::top).max().orElseThrow();
        double breadth = 0.5 * (cage.radius(Math.PI / 2, top - 40) + cage.radius(-Math.PI / 2, top - 40));
        double z = top - shape.pivotDepth() * breadth;
        pivot = new double[] {cage.x(z), cage.y(z), z};
        Map<Boolean, List<TriangleMesh>> organs = ContactingOrgans.abdominal(body).stream()
                .collect(Collectors.partitioningBy(
                        body::isInScan, Collectors.mapping(Structure::mesh, Collectors.toList())));
        Bounds bounds = new Bounds();
        bases.forEach(bounds::lung);
        ContactingOrgans.heart(body).forEach(heart -> bounds.heart(heart.mesh(), body.isInScan(heart)));
        bounds.organs(organs.get(true), organs.get(false), cage);
        insertion = new InsertionLine(new InsertionSites(body, cage), top - BELOW_TOP_MM);
        bounds.wall(cage);
        rho = bounds.solve(breadth * Math.toRadians(STEP_DEG), shape.smoothingMm());
    }

    /** The line of insertion, which nowhere reaches the top of the lungs' bases. */
    InsertionLine insertion() {
        return insertion;
    }

    double pivotZ() {
        return pivot[2];
    }

    private static double[] direction(int cell) {
        double u = (cell % SIDE - HALF + 0.5) * STEP_DEG;
        double v = (cell / SIDE - HALF + 0.5) * STEP_DEG;
        double polar = Math.toRadians(Math.sqrt(u * u + v * v));
        double sin = StrictMath.sin(polar) / Math.toRadians(Math.max(1e-9, Math.sqrt(u * u + v * v)));
        return new double[] {Math.toRadians(u) * sin, Math.toRadians(v) * sin, StrictMath.cos(polar)};
    }

    /** Distances of organs along the rays of all cells. */
    private final class Bounds {
        final double[] upper = new double[SIDE * SIDE];
        final double[] lower = new double[SIDE * SIDE];
        final double[] data = new double[SIDE * SIDE];
        final double[] weight = new double[SIDE * SIDE];
        /** Whether the scan shows what bounds the roof above. */
        final boolean[] shown = new boolean[SIDE * SIDE];

        Bounds() {
            Arrays.fill(upper, Double.POSITIVE_INFINITY);
        }

        void lung(LungBase base) {
            TriangleTree.Hit hit = new TriangleTree.Hit();
            for (int k = 0; k < upper.length; k++) {
                double[] d = direction(k);
                if (!base.tree.nearestAlongRay(pivot[0], pivot[1], pivot[2], d[0], d[1], d[2], hit)) {
                    continue;
                }
                double facing = base.facing(hit, d);
                double bound = hit.rayParameter - halfThickness / Math.max(LEAST_COSINE, Math.abs(facing));
                if (bound < upper[k]) {
                    upper[k] = bound;
                    shown[k] = base.isInScan();
                    boolean known = facing > LEAST_COSINE && base.liesOnDiaphragm() && base.isBase(hit);
                    data[k] = known ? bound : 0;
                    weight[k] = known ? 1 : 0;
                }
            }
        }

        /** The heart bounds the roof where no lung lies before it; fat and pericardium are between. */
        void heart(TriangleMesh heart, boolean inScan) {
            TriangleTree tree = new TriangleTree(heart);
            TriangleTree.Hit hit = new TriangleTree.Hit();
            for (int k = 0; k < upper.length; k++) {
                double[] d = direction(k);
                if (tree.nearestAlongRay(pivot[0], pivot[1], pivot[2], d[0], d[1], d[2], hit)
                        && hit.rayParameter - halfThickness < upper[k]) {
                    upper[k] = hit.rayParameter - halfThickness;
                    shown[k] = inScan;
                    data[k] = upper[k];
                    weight[k] = 0;
                }
            }
        }

        /**
         * Where organs overlap, those that the scan does not show give way to those that it shows.
         *
         * @param inScan organs that the scan shows
         * @param others organs of a template
         */
        void organs(List<TriangleMesh> inScan, List<TriangleMesh> others, CageEnvelope cage) {
            int ofScan = inScan.stream().mapToInt(TriangleMesh::triangleCount).sum();
            TriangleMesh organs = MeshMerge.merge(
                    Stream.concat(inScan.stream(), others.stream()).toList());
            TriangleTree tree = new TriangleTree(organs);
            double[] normals = MeshMeasure.triangleNormals(organs);
            TriangleTree.Hit hit = new TriangleTree.Hit();
            for (int k = 0; k < lower.length; k++) {
                double[] d = direction(k);
                lower[k] = 0;
                if (!tree.nearestAlongRay(
                                pivot[0] + FAR_MM * d[0],
                                pivot[1] + FAR_MM * d[1],
                                pivot[2] + FAR_MM * d[2],
                                -d[0],
                                -d[1],
                                -d[2],
                                hit)
                        || hit.rayParameter > FAR_MM) {
                    continue;
                }
                double facing = Math.abs(normals[3 * hit.triangle] * d[0]
                        + normals[3 * hit.triangle + 1] * d[1]
                        + normals[3 * hit.triangle + 2] * d[2]);
                double gap = halfThickness / Math.max(LEAST_COSINE, facing);
                lower[k] = FAR_MM - hit.rayParameter + gap;
                boolean organShown = hit.triangle < ofScan;
                if (upper[k] < lower[k] && shown[k] != organShown) {
                    lower[k] = organShown ? lower[k] : upper[k];
                    upper[k] = lower[k];
                }
                double open = upper[k] - lower[k];
                if (weight[k] > 0 && open < NEAR_MM) {
                    // Half of a narrow gap is above the sheet, less and less of a wider one.
                    double above = open <= 0 ? 0.5 : 0.5 * (1 - open / NEAR_MM);
                    data[k] = upper[k] - above * open;
                } else if (weight[k] == 0
                        && normals[3 * hit.triangle + 2] > ROOF_COSINE
                        && cage.at(hit.x, hit.y, hit.z) < 0) {
                    data[k] = lower[k];
                    weight[k] = ORGAN_WEIGHT;
                }
            }
        }

        /**
         * Keeps the roof outside the wall up to the insertion, unless lung or heart lies inside the wall there, so that
         * the roof meets the wall above the insertion.
         */
        void wall(CageEnvelope cage) {
            for (int k = 0; k < lower.length; k++) {
                double[] d = direction(k);
                double bound = upper[k];
                if (bound < Double.POSITIVE_INFINITY
                        && cage.at(pivot[0] + bound * d[0], pivot[1] + bound * d[1], pivot[2] + bound * d[2]) < 0) {
                    continue;
                }
                double r = RootFinder.firstOutward(
                        s -> cage.at(pivot[0] + s * d[0], pivot[1] + s * d[1], pivot[2] + s * d[2])
                                + Math.max(0, s - FAR_MM),
                        100);
                double z = pivot[2] + r * d[2];
                double azimuth = StrictMath.atan2(d[0], d[1]);
                if (d[2] < 0 || z < insertion.height(azimuth) + ABOVE_INSERTION_MM) {
                    lower[k] = Math.max(lower[k], Math.min(bound, r + BEYOND_WALL_MM));
                    weight[k] = 0;
                }
            }
        }

        /** Thin plate through the data; cells where it runs through an organ become data, at the organ's bound. */
        double[] solve(double stepMm, double smoothingMm) {
            ThinPlateGrid.Grid grid = new ThinPlateGrid.Grid(SIDE, SIDE, stepMm, stepMm, false);
            ThinPlateGrid.Stiffness stiffness = new ThinPlateGrid.Stiffness(smoothingMm, 0);
            double[] solved = {};
            for (int round = 0; round < ROUNDS; round++) {
                solved = ThinPlateGrid.solve(grid, new ThinPlateGrid.Data(data, weight), stiffness, solved);
                for (int k = 0; k < solved.length; k++) {
                    if (weight[k] > 0) {
                        continue;
                    }
                    boolean through = solved[k] > upper[k];
                    if (through || solved[k] < lower[k]) {
                        data[k] = through ? upper[k] : lower[k];
                        weight[k] = 1;
                    }
                }
            }
            return solved;
        }
    }

    /** Distance of the roof from the pivot along a direction, mm. */
    private double rho(double dx, double dy, double dz) {
        double across = Math.sqrt(dx * dx + dy * dy);
        double polar = Math.toDegrees(StrictMath.atan2(across, dz)) / STEP_DEG;
        double u = across > 0 ? dx / across * polar : 0;
        double v = across > 0 ? dy / across * polar : 0;
        double i = Math.max(0, Math.min(SIDE - 1.001, u + HALF - 0.5));
        double j = Math.max(0, Math.min(SIDE - 1.001, v + HALF - 0.5));
        int at = (int) i + SIDE * (int) j;
        double past = i - (int) i;
        double above = j - (int) j;
        return (1 - above) * ((1 - past) * rho[at] + past * rho[at + 1])
                + above * ((1 - past) * rho[at + SIDE] + past * rho[at + SIDE + 1]);
    }

    /** First-order distance to the roof, mm; negative below it. */
    @Override
    public double at(double px, double py, double pz) {
        double x = px - pivot[0];
        double y = py - pivot[1];
        double z = pz - pivot[2];
        double distance = Math.max(1e-6, Math.sqrt(x * x + y * y + z * z));
        if (z < DOWNWARD * distance) {
            return -distance;
        }
        double r = rho(x, y, z);
        double e = 0.02 * distance;
        double gx = (rho(x + e, y, z) - rho(x - e, y, z)) / (2 * e);
        double gy = (rho(x, y + e, z) - rho(x, y - e, z)) / (2 * e);
        double gz = (rho(x, y, z + e) - rho(x, y, z - e)) / (2 * e);
        // The radial derivative of rho vanishes, so its gradient is normal to the ray.
        return (distance - r) / Math.sqrt(1 + gx * gx + gy * gy + gz * gz);
    }
}
