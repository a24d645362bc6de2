package org.phrenic.anatomy.virtual.organ;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.phrenic.anatomy.virtual.shape.ImplicitSurface;
import org.phrenic.anatomy.virtual.shape.SmoothBlends;
import org.phrenic.file.Numbers;

/**
 * The region of one organ: its own shape, widened by an offset, less its hollows, cut to its space and to the organs
 * before it. The offset gives it its volume.
 */
final class OrganField implements ImplicitSurface {
    /** Largest offset, mm. */
    private static final double MAX_OFFSET_MM = 14;
    /** Organs farther than this from a point do not bound the region there. */
    private static final double FAR_MM = 8;

    private static final int BISECTIONS = 14;
    /** The volume is counted on a grid that is coarser than the mesh by this factor. */
    private static final double COARSER = 1.4;

    private final OrganParameters measures;
    private final List<Ellipsoid> ellipsoids;
    private final List<SweptTube> tubes = new ArrayList<>();
    private final List<Ellipsoid> hollows;
    private final ImplicitSurface space;
    private final List<OrganField> before;
    private final double gapMm;
    private final double[] box = new double[6];
    private double offset;

    /**
     * @param space the space that the organ is cut to
     * @param before organs that have their place already
     * @param gapMm distance to them
     * @throws IllegalArgumentException if no offset gives the volume
     */
    OrganField(OrganParameters measures, ImplicitSurface space, List<OrganField> before, double gapMm) {
        this.measures = measures;
        this.space = space;
        this.gapMm = gapMm;
        ellipsoids = measures.ellipsoids().stream().map(Ellipsoid::new).toList();
        hollows = measures.hollows().stream().map(Ellipsoid::new).toList();
        if (!measures.tube().isEmpty()) {
            tubes.add(new SweptTube(measures.tube()));
        }
        Arrays.fill(box, 0, 3, Double.POSITIVE_INFINITY);
        Arrays.fill(box, 3, 6, Double.NEGATIVE_INFINITY);
        ellipsoids.forEach(part -> part.extend(box));
        tubes.forEach(part -> part.extend(box));
        double margin = measures.gridMm() + (measures.volumeMl().isPresent() ? MAX_OFFSET_MM : 0);
        for (int axis = 0; axis < 3; axis++) {
            box[axis] -= margin;
            box[3 + axis] += margin;
        }
        this.before =
                before.stream().filter(other -> other.boxDistance(box) < FAR_MM).toList();
        measures.volumeMl().ifPresent(this::fitOffset);
    }

    private double boxDistance(double[] other) {
        double gap = Double.NEGATIVE_INFINITY;
        for (int axis = 0; axis < 3; axis++) {
            gap = Math.max(gap, Math.max(other[axis] - box[3 + axis], box[axis] - other[3 + axis]));
        }
        return gap;
    }

    private double boxDistance(double x, double y, double z) {
        return Math.max(
                Math.max(Math.max(box[0] - x, x - box[3]), Math.max(box[1] - y, y - box[4])),
                Math.max(box[2] - z, z - box[5]));
    }

    /** The organ's own shape with its offset before it is cut. */
    private double whole(double x, double y, double z) {
        return own(x, y, z) - offset;
    }

    /** The organ's own shape as stated. */
    private double own(double x, double y, double z) {
        double value = Double.POSITIVE_INFINITY;
        for (Ellipsoid part : ellipsoids) {
            value = unite(value, part.at(x, y, z));
        }
        for (SweptTube part : tubes) {
            value = unite(value, part.at(x, y, z));
        }
        return value;
    }

    private double unite(double a, double b) {
        return Double.isInfinite(a) ? b : SmoothBlends.smoothUnion(a, b, 2 * measures.filletMm());
    }

    /**
     * The region that the organ may fill. Others in the same space need not be cut to it: it bounds this organ as well.
     */
    private double limit(double x, double y, double z) {
        double value = space.at(x, y, z);
        for (Ellipsoid hollow : hollows) {
            value = Math.max(value, -hollow.at(x, y, z));
        }
        for (OrganField other : before) {
            if (other.boxDistance(x, y, z) < FAR_MM) {
                double whole = other.whole(x, y, z);
                boolean sameSpace = other.measures.in() == measures.in();
                value = Math.max(value, gapMm - (sameSpace ? whole : Math.max(whole, other.space.at(x, y, z))));
            }
        }
        return value;
    }

    @Override
    public double at(double x, double y, double z) {
        double shape = whole(x, y, z);
        return shape > FAR_MM ? shape : cut(shape, limit(x, y, z));
    }

    private double cut(double shape, double limit) {
        return SmoothBlends.roundIntersection(shape, limit, measures.filletMm());
    }

    private void fitOffset(double volumeMl) {
        double step = measures.gridMm() * COARSER;
        int[] size = new int[3];
        Arrays.setAll(size, axis -> (int) Math.ceil((box[3 + axis] - box[axis]) / step));
        double[] shape = new double[size[0] * size[1] * size[2]];
        double[] limit = new double[shape.length];
        for (int i = 0; i < shape.length; i++) {
            int row = i / size[0];
            int layer = row / size[1];
            double x = box[0] + (i % size[0] + 0.5) * step;
            double y = box[1] + (row % size[1] + 0.5) * step;
            double z = box[2] + (layer + 0.5) * step;
            shape[i] = own(x, y, z);
            limit[i] = shape[i] > MAX_OFFSET_MM + step ? step : limit(x, y, z);
        }
        double cellMl = step * step * step / 1000;
        double low = -MAX_OFFSET_MM;
        double high = MAX_OFFSET_MM;
        double least = cellMl * cells(shape, limit, low, step);
        double most = cellMl * cells(shape, limit, high, step);
        if (!(volumeMl >= least && volumeMl <= most)) {
            throw new IllegalArgumentException(Numbers.format(
                    "organs: found volume_ml %s of '%s', expected %.0f to %.0f ml for its shape and the room about it",
                    volumeMl, measures.name(), Math.ceil(least), Math.floor(most)));
        }
        for (int k = 0; k < BISECTIONS; k++) {
            offset = 0.5 * (low + high);
            if (cellMl * cells(shape, limit, offset, step) < volumeMl) {
                low = offset;
            } else {
                high = offset;
            }
        }
    }

    /** Number of cells of a grid within the region, with fractions of those at its surface. */
    private double cells(double[] shape, double[] limit, double offsetMm, double step) {
        double count = 0;
        for (int i = 0; i < shape.length; i++) {
            count += Math.max(0, Math.min(1, 0.5 - cut(shape[i] - offsetMm, limit[i]) / step));
        }
        return count;
    }

    /** Low and high corner of a box that contains the region. */
    double[] box() {
        return box;
    }

    OrganParameters measures() {
        return measures;
    }
}
