package org.phrenic.anatomy.virtual;

import java.util.Arrays;
import java.util.function.DoubleUnaryOperator;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.virtual.shape.Clearance;
import org.phrenic.anatomy.virtual.shape.ImplicitSurface;
import org.phrenic.anatomy.virtual.shape.MarchingTetrahedra;
import org.phrenic.anatomy.virtual.shape.Meridians;
import org.phrenic.anatomy.virtual.shape.RingMesh;
import org.phrenic.anatomy.virtual.shape.RootFinder;
import org.phrenic.anatomy.virtual.shape.SmoothBlends;
import org.phrenic.anatomy.virtual.shape.SurfaceRelaxation;
import org.phrenic.anatomy.virtual.shape.VerticalAxis;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;
import org.phrenic.mesh.edit.ConnectedComponents;
import org.phrenic.mesh.edit.LevelClip;
import org.phrenic.mesh.edit.SelfIntersectionSmoothing;

/**
 * A lung: the region inside the chest wall, above the diaphragm and lateral to the mediastinum. Its surface has two
 * pieces, the side (costal, mediastinal and apex) and the base, which meet in the sharp inferior border.
 */
final class LungShape implements VerticalAxis {
    /** Radius of the edges between the costal and the mediastinal surface of a lung, mm. */
    static final double COSTAL_EDGE_MM = 18;

    private static final double APEX_EDGE_MM = 12;
    private static final double PIVOT_ABOVE_DOME_MM = 45;
    private static final double BASE_PIVOT_BELOW_DOME_MM = 60;
    private static final double PLEURA_EDGE_MM = 14;
    private static final double PLEURA_MARGIN_MM = 30;
    private static final int PLEURA_SWEEPS = 10;
    /** Distance from the costal pleura over which the lower limit changes from its reflection to the diaphragm, mm. */
    private static final double OFF_WALL_MM = 6;

    private final VirtualThoraxParameters.Lungs measures;
    private final double costalEdgeMm;
    private final ChestWallShape wall;
    private final ImplicitSurface side = this::sideRegion;
    private final ImplicitSurface roof;
    private final DiaphragmShape dome;
    private final double roofOffset;
    private final int sign;
    private final int index;
    private final double[] apex;
    private final double[] base;
    private final double baseZ;

    /** @param costalEdgeMm radius of the edges between the costal and the mediastinal surface */
    LungShape(
            VirtualThoraxParameters.Lungs measures,
            VirtualThoraxParameters.Diaphragm diaphragm,
            ChestWallShape wall,
            DiaphragmShape dome,
            Side where,
            double costalEdgeMm) {
        this.measures = measures;
        this.costalEdgeMm = costalEdgeMm;
        this.wall = wall;
        sign = where.sign();
        index = where == Side.RIGHT ? 0 : 1;
        apex = index == 0 ? measures.apexRight().toArray() : measures.apexLeft().toArray();
        base = index == 0 ? measures.baseRight().toArray() : measures.baseLeft().toArray();
        baseZ = (index == 0 ? diaphragm.right() : diaphragm.left()).at(2);
        this.dome = dome;
        roofOffset = diaphragm.muscleMm() / 2 + measures.diaphragmGapMm();
        roof = (x, y, z) -> dome.at(x, y, z) - roofOffset;
    }

    /** The lung as a region. */
    ImplicitSurface region() {
        return (x, y, z) -> Math.max(sideRegion(x, y, z), -roof.at(x, y, z));
    }

    @Override
    public double x(double z) {
        return base[0] + (apex[0] - base[0]) * apexShare(z);
    }

    @Override
    public double y(double z) {
        return base[1] + (apex[1] - base[1]) * apexShare(z);
    }

    private double apexShare(double z) {
        return Math.max(-0.5, Math.min(1.2, (z - baseZ) / (apex[2] - baseZ)));
    }

    /** Implicit function of the lung without its base. */
    private double sideRegion(double x, double y, double z) {
        double costal = wall.at(x, y, z) + measures.wallInsetMm();
        double bulge = measures.heartMm().at(index) - measures.mediastinumMm().at(index);
        double back =
                (y - measures.heartCentre().at(0)) / measures.heartRadiiMm().at(0);
        double up = Math.max(
                0, (z - measures.heartCentre().at(1)) / measures.heartRadiiMm().at(1));
        double across = StrictMath.exp(-back * back);
        if (back < 0) {
            double share = measures.heartFrontShare().at(index);
            across = share + (1 - share) * across;
        }
        double medial = measures.mediastinumMm().at(index) + bulge * across * StrictMath.exp(-up * up) - sign * x;
        double dx = x - apex[0];
        double dy = y - apex[1];
        double cap = z - apex[2] + (dx * dx + dy * dy) / (2 * measures.apexRadiusMm());
        cap /= Math.sqrt(1 + (dx * dx + dy * dy) / (measures.apexRadiusMm() * measures.apexRadiusMm()));
        return SmoothBlends.roundIntersection(
                SmoothBlends.roundIntersection(costal, medial, costalEdgeMm), cap, APEX_EDGE_MM);
    }

    /** Point of the inferior border at an azimuth: the first intersection of the side with the base, from above. */
    private double[] lowerBorder(double azimuth) {
        return border(azimuth, h -> heightAboveRoof(azimuth, h));
    }

    /** Point of the side at an azimuth where a function of the height changes its sign first, from above. */
    private double[] border(double azimuth, DoubleUnaryOperator above) {
        double high = baseZ + PIVOT_ABOVE_DOME_MM;
        double low = high;
        while (above.applyAsDouble(low) > 0) {
            high = low;
            low -= 3;
            if (low < baseZ - 200) {
                throw new IllegalStateException("lung: the side never meets the diaphragm at azimuth " + azimuth);
            }
        }
        double z = RootFinder.illinois(above, low, above.applyAsDouble(low), high, above.applyAsDouble(high));
        return sidePoint(azimuth, z);
    }

    /**
     * The parietal pleura of the side without its diaphragmatic part: the costal part down to a line on the chest wall,
     * the mediastinal part down to the diaphragm.
     *
     * @param reflection height of the line on the chest wall at an azimuth about the axis of the wall (rad), mm
     */
    TriangleMesh pleura(DoubleUnaryOperator reflection) {
        double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, apex[2]};
        for (int i = 0; i < Meridians.AZIMUTHS; i++) {
            double azimuth = Meridians.azimuth(i);
            double[] end = border(azimuth, h -> aboveReflection(sidePoint(azimuth, h), reflection));
            double[] middle = sidePoint(azimuth, baseZ);
            for (int axis = 0; axis < 3; axis++) {
                low[axis] = Math.min(low[axis], Math.min(end[axis], middle[axis]));
                high[axis] = Math.max(high[axis], Math.max(end[axis], middle[axis]));
            }
        }
        double bottom = low[2] - PLEURA_EDGE_MM;
        ImplicitSurface region = (x, y, z) -> Math.max(sideRegion(x, y, z), bottom - z);
        double[] margin = {PLEURA_MARGIN_MM, PLEURA_MARGIN_MM, PLEURA_MARGIN_MM};
        TriangleMesh rough = MarchingTetrahedra.surface(
                region, Vectors.subtract(low, margin), Vectors.addScaled(high, margin, 1), PLEURA_EDGE_MM);
        TriangleMesh whole = SurfaceRelaxation.relax(ConnectedComponents.largest(rough), PLEURA_SWEEPS, v -> region);
        double[] p = whole.positions();
        double[] height = new double[whole.vertexCount()];
        Arrays.setAll(height, v -> aboveReflection(Arrays.copyOfRange(p, 3 * v, 3 * v + 3), reflection));
        return ConnectedComponents.largest(LevelClip.positivePart(whole, height));
    }

    /** Height above the line on the wall, off the wall the distance from the diaphragm. */
    private double aboveReflection(double[] p, DoubleUnaryOperator reflection) {
        double offWall = -wall.at(p) - measures.wallInsetMm();
        double share = SmoothBlends.smoothstep(offWall / OFF_WALL_MM);
        return (1 - share) * (p[2] - reflection.applyAsDouble(wall.azimuth(p))) + share * roof.at(p);
    }

    private double heightAboveRoof(double azimuth, double z) {
        return roof.at(sidePoint(azimuth, z));
    }

    private double[] sidePoint(double azimuth, double z) {
        return point(azimuth, RootFinder.firstOutward(s -> side.at(point(azimuth, s, z)), 20), z);
    }

    TriangleMesh mesh(int vertices) {
        double[][] limit = new double[Meridians.AZIMUTHS][];
        Arrays.setAll(limit, i -> lowerBorder(Meridians.azimuth(i)));
        Meridians sideLines = new Meridians(side, this, baseZ + PIVOT_ABOVE_DOME_MM, true, limit);
        Meridians baseLines = new Meridians(roof, this, baseZ - BASE_PIVOT_BELOW_DOME_MM, true, limit);
        double edge = RingMesh.edgeLengthFor(length -> count(sideLines, baseLines, length), vertices);
        int[] sideCounts = RingMesh.counts(sideLines, edge, 0);
        int border = sideCounts[sideCounts.length - 1];
        int[] baseCounts = RingMesh.counts(baseLines, edge, border);
        TriangleMesh upper = RingMesh.mesh(sideLines, sideCounts, true);
        TriangleMesh lower = RingMesh.mesh(baseLines, baseCounts, false);
        TriangleMesh whole = join(upper, lower, border);
        int inner = upper.vertexCount() - border;
        int upperCount = upper.vertexCount();

        TriangleMesh even = SurfaceRelaxation.relax(
                whole, measures.relaxationSweeps(), v -> v < inner ? side : v < upperCount ? null : roof);
        return SelfIntersectionSmoothing.smooth(Clearance.enforce(even, dome, 1, roofOffset));
    }

    private static int count(Meridians sideLines, Meridians baseLines, double edge) {
        int[] sideCounts = RingMesh.counts(sideLines, edge, 0);
        int border = sideCounts[sideCounts.length - 1];
        return RingMesh.vertexCount(sideCounts)
                + RingMesh.vertexCount(RingMesh.counts(baseLines, edge, border))
                - border;
    }

    /** Joins both meshes at the inferior border, whose vertices come last in each. */
    private static TriangleMesh join(TriangleMesh upper, TriangleMesh lower, int border) {
        int upperCount = upper.vertexCount();
        int lowerInner = lower.vertexCount() - border;
        double[] positions = new double[3 * (upperCount + lowerInner)];
        System.arraycopy(upper.positions(), 0, positions, 0, 3 * upperCount);
        System.arraycopy(lower.positions(), 0, positions, 3 * upperCount, 3 * lowerInner);
        int[] first = upper.triangles();
        int[] second = lower.triangles();
        int[] triangles = new int[first.length + second.length];
        System.arraycopy(first, 0, triangles, 0, first.length);
        for (int i = 0; i < second.length; i++) {
            int v = second[i];
            triangles[first.length + i] = v < lowerInner ? upperCount + v : upperCount - border + (v - lowerInner);
        }
        return new TriangleMesh(positions, triangles);
    }
}
