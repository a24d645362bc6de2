package org.phrenic.access.path;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.phrenic.access.CostalGroove;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.MovingStructure;
import org.phrenic.access.Needle;
import org.phrenic.access.NoGoZone;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.Vectors;
import org.phrenic.mesh.query.SegmentProbe;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.simulation.observe.Surface;

/**
 * Says what a straight path through a scene meets. Keeps working memory: one a thread.
 *
 * <p>A path begins on the skin, so the skin is not asked. Within a closed surface it is from an entry to the matching
 * exit; what an open surface leaves without an exit lasts to the path's end, and an exit without an entry began at the
 * path's start.
 */
public final class PathAnalyzer {
    /** Structures farther than this from a path are not listed, mm. */
    public static final double MAX_DISTANCE_MM = 40;

    private final MovingAnatomy scene;
    private final double radius;
    private final SegmentProbe probe = new SegmentProbe();
    private final TriangleTree.Hit hit = new TriangleTree.Hit();
    private String nearestOfMargin = "";

    /**
     * @param scene what is asked; the reader sees the frame that it took last
     * @param needle whose radius counts: what is nearer than it is touched
     */
    public PathAnalyzer(MovingAnatomy scene, Needle needle) {
        this.scene = scene;
        radius = needle.radiusMm();
    }

    /** All about the path from a point on the skin to a point within. */
    public PathAnalysis analyze(double[] entry, double[] end) {
        List<Crossing> crossings = new ArrayList<>();
        List<Approach> approaches = new ArrayList<>();
        for (MovingStructure s : scene.structures()) {
            if (s.surface().kind() != StructureKind.SKIN) {
                crossings.addAll(crossingsOf(s, entry, end));
            }
            if (s.noGo().isPresent()) {
                double distance = distance(s, entry, end, MAX_DISTANCE_MM);
                if (distance < MAX_DISTANCE_MM) {
                    approaches.add(new Approach(s.surface().name(), s.label(), distance, probe.nearestDepth()));
                }
            }
        }
        approaches.sort(Comparator.comparingDouble(Approach::distanceMm).thenComparing(Approach::name));
        double depth = chestWallDepth(entry, end);
        recess(entry, end, depth, crossings).ifPresent(crossings::add);
        crossings.sort(Comparator.comparingDouble(Crossing::fromMm).thenComparing(Crossing::name));
        double border = MAX_DISTANCE_MM;
        String borderOf = "";
        for (CostalGroove b : scene.borders()) {
            double d = b.distance(entry, end, probe, border);
            if (d < border) {
                border = d;
                borderOf = b.rib().label();
            }
        }
        return new PathAnalysis(
                scene.timeS(),
                Vectors.distance(entry, end),
                List.copyOf(crossings),
                space(entry, end, depth),
                List.copyOf(approaches),
                border,
                borderOf,
                capsuleAngle(entry, end),
                NoGoZone.of(touched(entry, end)));
    }

    /** The stretches of a path within one structure. */
    public List<Crossing> crossingsOf(MovingStructure s, double[] entry, double[] end) {
        s.setProbe(entry, end, probe);
        int count = probe.intersect(s.tree());
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

    /**
     * Distance of a path from a structure, no more than {@code limit}; then {@link SegmentProbe#nearestDepth} is where.
     */
    private double distance(MovingStructure s, double[] entry, double[] end, double limit) {
        if (s.boxDistance(entry, end) >= limit) {
            return limit;
        }
        s.setProbe(entry, end, probe);
        return probe.distance(s.tree(), limit);
    }

    /** What of {@link NoGoZone} a path touches, a bit each. */
    int touched(double[] entry, double[] end) {
        int bits = 0;
        for (MovingStructure s : scene.hazards()) {
            int bit = s.noGo().orElseThrow().bit();
            if ((bits & bit) == 0 && distance(s, entry, end, radius) < radius) {
                bits |= bit;
            }
        }
        for (CostalGroove b : scene.borders()) {
            if (b.distance(entry, end, probe, CostalGroove.NEUROVASCULAR_ZONE_MM)
                    < CostalGroove.NEUROVASCULAR_ZONE_MM) {
                bits |= NoGoZone.VESSELS.bit();
                break;
            }
        }
        return crossesPleura(entry, end) ? bits | NoGoZone.PLEURA.bit() : bits;
    }

    /**
     * Distance from the nearest of what is to be avoided, less the needle's radius or the width of the vessels' zone,
     * mm; no more than {@value #MAX_DISTANCE_MM}. The pleural recess has no distance: it is crossed or not.
     *
     * @return 0 where one is touched
     */
    public double margin(double[] entry, double[] end, Set<NoGoZone> avoided) {
        double margin = MAX_DISTANCE_MM;
        nearestOfMargin = "";
        for (MovingStructure s : scene.hazards()) {
            if (avoided.contains(s.noGo().orElseThrow())) {
                double d = distance(s, entry, end, margin + radius);
                if (d < margin + radius) {
                    margin = d - radius;
                    nearestOfMargin = s.surface().name();
                }
            }
        }
        if (avoided.contains(NoGoZone.VESSELS)) {
            for (CostalGroove b : scene.borders()) {
                double d = b.distance(entry, end, probe, margin + CostalGroove.NEUROVASCULAR_ZONE_MM);
                if (d < margin + CostalGroove.NEUROVASCULAR_ZONE_MM) {
                    margin = d - CostalGroove.NEUROVASCULAR_ZONE_MM;
                    nearestOfMargin =
                            MovingAnatomy.VESSELS_PREFIX + b.rib().surface().name();
                }
            }
        }
        return Math.max(0, margin);
    }

    /** What the last {@link #margin} was taken from; empty if nothing was near. */
    public String nearestOfMargin() {
        return nearestOfMargin;
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
        sheet.setProbe(entry, end, probe);
        int count = probe.intersect(sheet.tree());
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
        return scene.pleura().orElseThrow().isAbove(mean[0], mean[1], mean[2]);
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
    private double chestWallDepth(double[] entry, double[] end) {
        double best = MAX_DISTANCE_MM;
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
        double[] at = Vectors.addScaled(entry, Vectors.normalize(Vectors.subtract(end, entry)), depth);
        int above = 0;
        int below = Integer.MAX_VALUE;
        Side side = Side.MIDLINE;
        double nearest = MAX_DISTANCE_MM;
        for (MovingStructure s : scene.hazards()) {
            double[] own = s.toLocal(at);
            if (!isCage(s.surface().kind()) || !s.tree().closest(own[0], own[1], own[2], MAX_DISTANCE_MM, hit)) {
                continue;
            }
            double[] point = s.toWorld(new double[] {hit.x, hit.y, hit.z});
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
        liver.setProbe(entry, end, probe);
        int count = probe.intersect(liver.tree());
        for (int i = 0; i < count; i++) {
            if (probe.facing(i) > 0) {
                double[] normal = normal(liver, probe.triangle(i));
                double[] own = Vectors.subtract(liver.toLocal(end), liver.toLocal(entry));
                return 90 - Math.min(90, Vectors.angleDeg(Vectors.subtract(new double[3], own), normal));
            }
        }
        return Double.NaN;
    }

    private static double[] normal(MovingStructure s, int triangle) {
        int[] t = s.surface().rest().triangles();
        double[] p = s.positions();
        double[][] corner = new double[3][];
        for (int k = 0; k < 3; k++) {
            int v = 3 * t[3 * triangle + k];
            corner[k] = new double[] {p[v], p[v + 1], p[v + 2]};
        }
        double[] u = Vectors.subtract(corner[1], corner[0]);
        double[] v = Vectors.subtract(corner[2], corner[0]);
        return new double[] {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    }
}
