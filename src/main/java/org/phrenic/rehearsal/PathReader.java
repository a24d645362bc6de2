package org.phrenic.rehearsal;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.geometry.SegmentProbe;
import org.phrenic.geometry.TriangleTree;
import org.phrenic.geometry.Vectors;
import org.phrenic.simulation.Surface;

/**
 * Says what a straight path through a scene meets. Keeps working memory: one a thread.
 *
 * <p>A path begins on the skin, so the skin is not asked. Within a closed surface it is from an entry to the matching exit; what an open surface leaves without an exit lasts to the path's end, and an exit without an entry began at the path's
 * start.
 */
public final class PathReader {
    /** Structures farther than this from a path are not listed, mm. */
    public static final double REACH_MM = 40;

    /** What {@link #nearest} begins with where it is the lower border of a rib. */
    static final String VESSELS = "vessels_";

    private final MovingScene scene;
    private final double radius;
    private final SegmentProbe probe = new SegmentProbe();
    private final TriangleTree.Hit hit = new TriangleTree.Hit();
    private String nearest = "";

    /**
     * @param scene what is asked; the reader sees the frame that it took last
     * @param needle whose radius counts: what is nearer than it is touched
     */
    public PathReader(MovingScene scene, Needle needle) {
        this.scene = scene;
        radius = needle.radiusMm();
    }

    /** All about the path from a point on the skin to a point within. */
    public PathReading read(double[] entry, double[] end) {
        List<Crossing> crossings = new ArrayList<>();
        List<Approach> approaches = new ArrayList<>();
        for (MovingStructure s : scene.structures()) {
            if (s.surface().kind() != StructureKind.SKIN) {
                crossings.addAll(within(s, entry, end));
            }
            if (s.noGo().isPresent()) {
                double distance = distance(s, entry, end, REACH_MM);
                if (distance < REACH_MM) {
                    approaches.add(new Approach(s.surface().name(), s.label(), distance, probe.nearestDepth()));
                }
            }
        }
        approaches.sort(Comparator.comparingDouble(Approach::distanceMm).thenComparing(Approach::name));
        double depth = wallDepth(entry, end);
        recess(entry, end, depth, crossings).ifPresent(crossings::add);
        crossings.sort(Comparator.comparingDouble(Crossing::fromMm).thenComparing(Crossing::name));
        double border = REACH_MM;
        String borderOf = "";
        for (RibBorder b : scene.borders()) {
            double d = b.distance(entry, end, probe, border);
            if (d < border) {
                border = d;
                borderOf = b.rib().label();
            }
        }
        return new PathReading(
                scene.timeS(),
                Vectors.distance(entry, end),
                List.copyOf(crossings),
                space(entry, end, depth),
                List.copyOf(approaches),
                border,
                borderOf,
                capsuleAngle(entry, end),
                NoGo.of(touched(entry, end)));
    }

    /** The stretches of a path within one structure. */
    List<Crossing> within(MovingStructure s, double[] entry, double[] end) {
        s.lay(entry, end, probe);
        int count = probe.pierce(s.tree());
        List<Crossing> out = new ArrayList<>();
        int depth = 0;
        double since = 0;
        for (int i = 0; i < count; i++) {
            if (probe.facing(i) > 0) {
                since = depth == 0 ? probe.depth(i) : since;
                depth++;
            } else {
                depth = Math.max(0, depth - 1);
                if (depth == 0) {
                    out.add(crossing(s, since, probe.depth(i)));
                    since = probe.depth(i);
                }
            }
        }
        if (depth > 0) {
            out.add(crossing(s, since, probe.length()));
        }
        return out;
    }

    private static Crossing crossing(MovingStructure s, double from, double to) {
        return new Crossing(s.surface().name(), s.label(), s.surface().kind(), from, to);
    }

    /** Distance of a path from a structure, no more than {@code limit}; then {@link SegmentProbe#nearestDepth} is where. */
    private double distance(MovingStructure s, double[] entry, double[] end, double limit) {
        if (s.gap(entry, end) >= limit) {
            return limit;
        }
        s.lay(entry, end, probe);
        return probe.distance(s.tree(), limit);
    }

    /** What of {@link NoGo} a path touches, a bit each. */
    int touched(double[] entry, double[] end) {
        int bits = 0;
        for (MovingStructure s : scene.hazards()) {
            int bit = s.noGo().orElseThrow().bit();
            if ((bits & bit) == 0 && distance(s, entry, end, radius) < radius) {
                bits |= bit;
            }
        }
        for (RibBorder b : scene.borders()) {
            if (b.distance(entry, end, probe, RibBorder.ZONE_MM) < RibBorder.ZONE_MM) {
                bits |= NoGo.VESSELS.bit();
                break;
            }
        }
        return crossesPleura(entry, end) ? bits | NoGo.PLEURA.bit() : bits;
    }

    /**
     * Distance from the nearest of what is to be avoided, less the needle's radius or the width of the vessels' zone, mm; no more than {@value #REACH_MM}. The pleural recess has no distance: it is crossed or not.
     *
     * @return 0 where one is touched
     */
    double margin(double[] entry, double[] end, Set<NoGo> avoided) {
        double margin = REACH_MM;
        nearest = "";
        for (MovingStructure s : scene.hazards()) {
            if (avoided.contains(s.noGo().orElseThrow())) {
                double d = distance(s, entry, end, margin + radius);
                if (d < margin + radius) {
                    margin = d - radius;
                    nearest = s.surface().name();
                }
            }
        }
        if (avoided.contains(NoGo.VESSELS)) {
            for (RibBorder b : scene.borders()) {
                double d = b.distance(entry, end, probe, margin + RibBorder.ZONE_MM);
                if (d < margin + RibBorder.ZONE_MM) {
                    margin = d - RibBorder.ZONE_MM;
                    nearest = VESSELS + b.rib().surface().name();
                }
            }
        }
        return Math.max(0, margin);
    }

    /** What the last {@link #margin} was taken from; empty if nothing was near. */
    String nearest() {
        return nearest;
    }

    private boolean crossesPleura(double[] entry, double[] end) {
        return pleuralDepth(entry, end) < Double.POSITIVE_INFINITY;
    }

    /** Depth at which a path enters the diaphragm from the recess; infinite where it does not. */
    private double pleuralDepth(double[] entry, double[] end) {
        if (scene.diaphragm().isEmpty()) {
            return Double.POSITIVE_INFINITY;
        }
        MovingStructure sheet = scene.diaphragm().get();
        sheet.lay(entry, end, probe);
        int count = probe.pierce(sheet.tree());
        for (int i = 0; i < count; i++) {
            if (probe.facing(i) > 0 && isPleural(sheet.surface(), probe.triangle(i))) {
                return probe.depth(i);
            }
        }
        return Double.POSITIVE_INFINITY;
    }

    private boolean isPleural(Surface sheet, int triangle) {
        double[] mean = new double[3];
        for (int k = 0; k < 3; k++) {
            int v = sheet.rest().triangles()[3 * triangle + k];
            mean[0] += sheet.rest().x(v) / 3;
            mean[1] += sheet.rest().y(v) / 3;
            mean[2] += sheet.rest().z(v) / 3;
        }
        return scene.pleura().orElseThrow().isPleural(mean[0], mean[1], mean[2]);
    }

    /** The stretch of a path between the cage's wall and the diaphragm where there is no lung. */
    private Optional<Crossing> recess(double[] entry, double[] end, double wall, List<Crossing> crossings) {
        double depth = pleuralDepth(entry, end);
        if (depth == Double.POSITIVE_INFINITY) {
            return Optional.empty();
        }
        double from = Double.isNaN(wall) ? depth : Math.min(wall, depth);
        for (Crossing c : crossings) {
            if (c.kind() == StructureKind.LUNG && c.fromMm() < depth) {
                from = Math.max(from, Math.min(c.toMm(), depth));
            }
        }
        return Optional.of(new Crossing(Crossing.RECESS, "pleural recess", StructureKind.OTHER, from, depth));
    }

    /** Depth at which the path is nearest to a rib or cartilage; NaN where none is within reach. */
    private double wallDepth(double[] entry, double[] end) {
        double best = REACH_MM;
        double depth = Double.NaN;
        for (MovingStructure s : scene.hazards()) {
            if (isCage(s.surface().kind())) {
                double d = distance(s, entry, end, best);
                if (d < best) {
                    best = d;
                    depth = probe.nearestDepth();
                }
            }
        }
        return depth;
    }

    private static boolean isCage(StructureKind kind) {
        return kind == StructureKind.RIB || kind == StructureKind.COSTAL_CARTILAGE;
    }

    /** Between which neighbouring ribs, with their cartilages, a path passes at the depth of the wall. */
    private Optional<IntercostalSpace> space(double[] entry, double[] end, double depth) {
        if (Double.isNaN(depth)) {
            return Optional.empty();
        }
        double[] at = Vectors.add(entry, Vectors.unit(Vectors.minus(end, entry)), depth);
        int above = 0;
        int below = Integer.MAX_VALUE;
        Side side = Side.MIDLINE;
        double nearest = REACH_MM;
        for (MovingStructure s : scene.hazards()) {
            double[] own = s.own(at);
            if (!isCage(s.surface().kind()) || !s.tree().closest(own[0], own[1], own[2], REACH_MM, hit)) {
                continue;
            }
            double[] point = s.world(new double[] {hit.x, hit.y, hit.z});
            if (point[2] > at[2]) {
                above = Math.max(above, s.surface().level());
            } else {
                below = Math.min(below, s.surface().level());
            }
            if (hit.distanceSquared < nearest * nearest) {
                nearest = Math.sqrt(hit.distanceSquared);
                side = s.surface().side();
            }
        }
        return above > 0 && below == above + 1 ? Optional.of(new IntercostalSpace(above, side)) : Optional.empty();
    }

    /** Angle between a path and the liver's surface where it first enters, degrees; NaN where it does not. */
    double capsuleAngle(double[] entry, double[] end) {
        MovingStructure liver = scene.liver();
        liver.lay(entry, end, probe);
        int count = probe.pierce(liver.tree());
        for (int i = 0; i < count; i++) {
            if (probe.facing(i) > 0) {
                double[] normal = normal(liver, probe.triangle(i));
                double[] own = Vectors.minus(liver.own(end), liver.own(entry));
                return 90 - Math.min(90, Vectors.angleDeg(Vectors.minus(new double[3], own), normal));
            }
        }
        return Double.NaN;
    }

    private static double[] normal(MovingStructure s, int triangle) {
        int[] t = s.surface().rest().triangles();
        double[] p = s.now();
        double[][] corner = new double[3][];
        for (int k = 0; k < 3; k++) {
            int v = 3 * t[3 * triangle + k];
            corner[k] = new double[] {p[v], p[v + 1], p[v + 2]};
        }
        double[] u = Vectors.minus(corner[1], corner[0]);
        double[] v = Vectors.minus(corner[2], corner[0]);
        return new double[] {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    }
}
