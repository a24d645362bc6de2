package org.phrenic.anatomy.cage;

import org.phrenic.engine.constraint.ContactSurface;
import org.phrenic.engine.parallel.Workers;

/**
 * The inner surface of the chest wall (the parietal pleura) as a radius r_wall(φ, z) about a vertical line through the
 * middle of the chest. At rest it is the outer envelope of the lungs and the apposed part of the diaphragm. Each grid
 * cell moves with the bones near it, so that contact is with the moving ribs.
 *
 * <p>A point is mapped back to rest by the local displacement of the wall. There the level-set function G = r_wall(φ,
 * z) - r is evaluated; G and its gradient define the tangent plane.
 */
public final class MovingChestWall {
    private static final int SECTORS = 96;
    private static final int QUARTER = SECTORS / 4;
    private static final double LAYER_MM = 5;
    /**
     * Maximum spacing of the points that define the wall, mm. With wider spacing a cell could contain no point of the
     * outer surface, and a point behind it would define the wall.
     */
    public static final double MAX_SPACING_MM = LAYER_MM / 2;

    private static final int SMOOTHINGS = 2;
    /**
     * Least distance from the line of a place that has a wall, mm. Nearer to it the radius depends on a direction that
     * a small motion turns, and the crura in front of the spine are not apposed to the chest wall.
     */
    private static final double LEAST_RADIUS_MM = 25;

    private final double centreX;
    private final double centreY;
    private final double bottom;
    private final int layers;
    private final double[] radius;
    private final LinearBlendSkinning motion;
    private final double[] restPoint;
    private final double[] displaced;
    private final double[] velocity;
    private double time = Double.NaN;

    /**
     * @param contents points at rest (three numbers each, mm) whose envelope is the wall: all of the lungs and of the
     *     thoracic face of the diaphragm, at most {@link #MAX_SPACING_MM} apart
     * @param centreX x of the vertical line, mm
     * @param centreY y of the vertical line, mm
     * @param bones skinning weights of the wall
     * @param pose pose of the rib cage
     * @param workers threads that move the wall
     */
    public MovingChestWall(
            double[] contents,
            double centreX,
            double centreY,
            SkinningWeights bones,
            RibCagePose pose,
            Workers workers) {
        this.centreX = centreX;
        this.centreY = centreY;
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        for (int i = 2; i < contents.length; i += 3) {
            low = Math.min(low, contents[i]);
            high = Math.max(high, contents[i]);
        }
        bottom = low - 2 * LAYER_MM;
        layers = (int) Math.ceil((high - bottom) / LAYER_MM) + 3;
        radius = envelope(contents);
        restPoint = new double[3 * SECTORS * layers];
        for (int layer = 0; layer < layers; layer++) {
            for (int sector = 0; sector < SECTORS; sector++) {
                int cell = layer * SECTORS + sector;
                double[] direction = direction(sector);
                restPoint[3 * cell] = centreX + radius[cell] * direction[0];
                restPoint[3 * cell + 1] = centreY + radius[cell] * direction[1];
                restPoint[3 * cell + 2] = bottom + layer * LAYER_MM;
            }
        }
        motion = new LinearBlendSkinning(pose, restPoint, bones.weightsAt(restPoint), workers);
        displaced = new double[restPoint.length];
        velocity = new double[restPoint.length];
    }

    /**
     * Contact surface for nodes that must stay inside the wall. A node that lies outside the smoothed wall at rest may
     * stay outside by that distance.
     *
     * @param points positions of the nodes at rest, mm
     * @param inset minimum depth of each node inside the wall, mm: 0 for the outer face, more for the face behind it
     */
    public ContactSurface limitingContact(double[] points, double[] inset) {
        double[] allowance = new double[points.length / 3];
        for (int i = 0; i < allowance.length; i++) {
            allowance[i] = Math.max(-inset[i], -depth(points[3 * i], points[3 * i + 1], points[3 * i + 2]));
        }
        return surface(allowance);
    }

    /** Contact surface for nodes that slide along the wall at their distance at rest. */
    public ContactSurface slidingContact(double[] points) {
        double[] allowance = new double[points.length / 3];
        for (int i = 0; i < allowance.length; i++) {
            allowance[i] = -depth(points[3 * i], points[3 * i + 1], points[3 * i + 2]);
        }
        return surface(allowance);
    }

    private ContactSurface surface(double[] allowance) {
        return new ContactSurface() {
            @Override
            public void prepare(double now) {
                moveTo(now);
            }

            @Override
            public void tangentPlane(int node, double x, double y, double z, double[] plane, int at) {
                plane(allowance[node], x, y, z, plane, at);
            }
        };
    }

    /** Radial depth of a point inside the wall at rest, mm; negative outside. */
    public double depth(double px, double py, double pz) {
        double x = px - centreX;
        double y = py - centreY;
        return radiusAt(diamondAngle(x, y), (pz - bottom) / LAYER_MM) - Math.sqrt(x * x + y * y);
    }

    /** Whether a place is far enough from the vertical line through the middle of the chest for contact. */
    public boolean isAwayFromAxis(double px, double py) {
        double x = px - centreX;
        double y = py - centreY;
        return x * x + y * y >= LEAST_RADIUS_MM * LEAST_RADIUS_MM;
    }

    /** Radially outward component of a unit vector at a point, -1 to 1. */
    public double outwardComponent(double px, double py, double nx, double ny) {
        double x = px - centreX;
        double y = py - centreY;
        return (nx * x + ny * y) / Math.max(1e-9, Math.sqrt(x * x + y * y));
    }

    /**
     * Angular coordinate about the line, 0 to {@value #SECTORS}: the "diamond angle", which grows within each quadrant
     * as y / (|x| + |y|). It costs one division; an arc tangent costs about thirty times as much.
     */
    private static double diamondAngle(double x, double y) {
        double size = Math.abs(x) + Math.abs(y);
        if (size == 0) {
            return 0;
        }
        double along = y / size;
        double quarters = x < 0 ? 2 - along : y < 0 ? 4 + along : along;
        return quarters < 4 ? quarters * QUARTER : 0;
    }

    /** Unit vector with the given {@link #diamondAngle}. */
    private static double[] direction(int sector) {
        double quarters = sector / (double) QUARTER;
        double y = quarters <= 1 ? quarters : quarters <= 3 ? 2 - quarters : quarters - 4;
        double x = quarters <= 2 ? 1 - quarters : quarters - 3;
        double length = Math.sqrt(x * x + y * y);
        return new double[] {x / length, y / length};
    }

    private double[] envelope(double[] contents) {
        double[] r = new double[SECTORS * layers];
        for (int i = 0; i < contents.length; i += 3) {
            double x = contents[i] - centreX;
            double y = contents[i + 1] - centreY;
            int sector = (int) Math.round(diamondAngle(x, y)) % SECTORS;
            int layer = (int) Math.round((contents[i + 2] - bottom) / LAYER_MM);
            int cell = layer * SECTORS + sector;
            r[cell] = Math.max(r[cell], Math.sqrt(x * x + y * y));
        }
        fillEmptyCells(r);
        for (int i = 0; i < SMOOTHINGS; i++) {
            smooth(r);
        }
        return r;
    }

    /** Fills empty cells with the mean of their filled neighbours, repeatedly until none is empty. */
    private void fillEmptyCells(double[] r) {
        boolean empty = true;
        while (empty) {
            empty = false;
            double[] before = r.clone();
            for (int cell = 0; cell < r.length; cell++) {
                if (before[cell] > 0) {
                    continue;
                }
                double sum = 0;
                int count = 0;
                for (int near : neighbours(cell)) {
                    if (before[near] > 0) {
                        sum += before[near];
                        count++;
                    }
                }
                if (count > 0) {
                    r[cell] = sum / count;
                } else {
                    empty = true;
                }
            }
        }
    }

    private void smooth(double[] r) {
        double[] before = r.clone();
        for (int cell = 0; cell < r.length; cell++) {
            double sum = 0;
            int[] near = neighbours(cell);
            for (int n : near) {
                sum += before[n];
            }
            r[cell] = 0.5 * before[cell] + 0.5 * sum / near.length;
        }
    }

    private int[] neighbours(int cell) {
        int layer = cell / SECTORS;
        int sector = cell % SECTORS;
        int below = Math.max(0, layer - 1);
        int above = Math.min(layers - 1, layer + 1);
        return new int[] {
            layer * SECTORS + (sector + 1) % SECTORS,
            layer * SECTORS + (sector + SECTORS - 1) % SECTORS,
            below * SECTORS + sector,
            above * SECTORS + sector
        };
    }

    /** Bilinear radius at a fractional sector and layer. */
    private double radiusAt(double sector, double layer) {
        int below = (int) clampLayer(layer);
        return bilinearRadius(below, clampLayer(layer) - below, (int) sector, sector - (int) sector);
    }

    private double clampLayer(double layer) {
        return Math.max(0, Math.min(layers - 1.001, layer));
    }

    /** Bilinear radius; {@code above} and {@code past} are the fractions within the cell. */
    private double bilinearRadius(int layer, double above, int sector, double past) {
        int lower = layer * SECTORS;
        int next = sector + 1 < SECTORS ? sector + 1 : 0;
        double below = (1 - past) * radius[lower + sector] + past * radius[lower + next];
        double over = (1 - past) * radius[lower + SECTORS + sector] + past * radius[lower + SECTORS + next];
        return (1 - above) * below + above * over;
    }

    /** Bilinear radius at a fractional sector that may lie just outside the range; it is wrapped. */
    private double bilinearRadiusWrapped(int layer, double above, double sector) {
        double round = sector < 0 ? sector + SECTORS : sector < SECTORS ? sector : sector - SECTORS;
        return bilinearRadius(layer, above, (int) round, round - (int) round);
    }

    /** Lets the wall be moved anew when it is next asked for, also at the same time: its bones may move otherwise. */
    public void invalidate() {
        time = Double.NaN;
    }

    private void moveTo(double now) {
        if (now == time) {
            return;
        }
        time = now;
        motion.at(now, displaced, velocity);
        for (int i = 0; i < displaced.length; i++) {
            displaced[i] -= restPoint[i];
        }
    }

    private void plane(double allowance, double px, double py, double pz, double[] plane, int at) {
        double x = px - centreX;
        double y = py - centreY;
        // Interpolate the displacement of the wall between cells. The displacement of the nearest cell would be
        // discontinuous where a point changes cells.
        double here = diamondAngle(x, y);
        double height = clampLayer((pz - bottom) / LAYER_MM);
        int cell = ((int) height) * SECTORS + (int) here;
        int next = here < SECTORS - 1 ? cell + 1 : cell + 1 - SECTORS;
        double above = height - (int) height;
        double past = here - (int) here;
        double w00 = (1 - above) * (1 - past);
        double w01 = (1 - above) * past;
        double w10 = above * (1 - past);
        double w11 = above * past;
        double[] u = displaced;
        x -= mean(u, 3 * cell, 3 * next, w00, w01, w10, w11);
        y -= mean(u, 3 * cell + 1, 3 * next + 1, w00, w01, w10, w11);
        double z = pz - mean(u, 3 * cell + 2, 3 * next + 2, w00, w01, w10, w11);
        double r = Math.max(1, Math.sqrt(x * x + y * y));
        double sector = diamondAngle(x, y);
        double layer = (z - bottom) / LAYER_MM;
        int whole = (int) sector;
        double beyond = sector - whole;
        double level = clampLayer(layer);
        int below = (int) level;
        double wall = bilinearRadius(below, level - below, whole, beyond);
        double slopeSector = bilinearRadiusWrapped(below, level - below, sector + 0.5)
                - bilinearRadiusWrapped(below, level - below, sector - 0.5);
        double higher = clampLayer(layer + 0.5);
        double lower = clampLayer(layer - 0.5);
        double slopeHeight = (bilinearRadius((int) higher, higher - (int) higher, whole, beyond)
                        - bilinearRadius((int) lower, lower - (int) lower, whole, beyond))
                / LAYER_MM;
        // Gradient of G = r_wall - r: the gradient of the sector is parallel to (-y, x) / (|x| + |y|)².
        double size = Math.max(1, Math.abs(x) + Math.abs(y));
        double turn = slopeSector * QUARTER / (size * size);
        double gx = -turn * y - x / r;
        double gy = turn * x - y / r;
        double gz = slopeHeight;
        double length = Math.sqrt(gx * gx + gy * gy + gz * gz);
        double gap = (wall + allowance - r) / length;
        gx /= length;
        gy /= length;
        gz /= length;
        plane[at] = gx;
        plane[at + 1] = gy;
        plane[at + 2] = gz;
        plane[at + 3] = gx * px + gy * py + gz * pz - gap;
        double[] v = velocity;
        plane[at + 4] = gx * mean(v, 3 * cell, 3 * next, w00, w01, w10, w11)
                + gy * mean(v, 3 * cell + 1, 3 * next + 1, w00, w01, w10, w11)
                + gz * mean(v, 3 * cell + 2, 3 * next + 2, w00, w01, w10, w11);
    }

    /** Bilinear interpolation of one component of a per-cell vector field between two cells and the two above them. */
    private static double mean(double[] of, int cell, int next, double w00, double w01, double w10, double w11) {
        return w00 * of[cell] + w01 * of[next] + w10 * of[cell + 3 * SECTORS] + w11 * of[next + 3 * SECTORS];
    }
}
