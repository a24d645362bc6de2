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
import org.phrenic.anatomy.StructureKind;
import org.phrenic.engine.math.Triangles;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.Vectors;
import org.phrenic.mesh.query.SegmentProbe;

/**
 * Finds the structures that a straight path crosses or approaches in the current frame. Not thread-safe.
 *
 * <p>A path starts on the skin, so the skin itself is not tested. A path is inside a closed surface between an entry
 * and the matching exit. An entry without an exit extends to the end of the path. An exit without an entry extends back
 * to its start.
 */
public final class PathAnalyzer {
    /** Maximum distance at which structures are reported, mm. */
    public static final double MAX_DISTANCE_MM = 40;

    private static final double NONE = Double.POSITIVE_INFINITY;

    private final MovingAnatomy anatomy;
    private final double radius;
    private final SegmentProbe probe = new SegmentProbe();
    private final EntryWays ways;

    /**
     * Safety margin of a path.
     *
     * @param mm distance to the nearest avoided zone minus the needle radius or the width of the vessel zone, mm; at
     *     most {@link #MAX_DISTANCE_MM}; 0 if a zone is touched
     * @param nearest structure that the margin is measured from, with {@link MovingAnatomy#VESSELS_PREFIX} for a costal
     *     groove; empty if none is in range
     */
    public record Margin(double mm, String nearest) {}

    /** @param needle the needle; structures closer than its radius count as touched */
    public PathAnalyzer(MovingAnatomy anatomy, Needle needle) {
        this.anatomy = anatomy;
        ways = new EntryWays(anatomy, needle);
        radius = needle.radiusMm();
    }

    /** Analyses the path from a point on the skin to a point inside the body. */
    public PathAnalysis analyze(double[] entry, double[] end) {
        List<Crossing> crossings = new ArrayList<>();
        List<Approach> approaches = new ArrayList<>();
        for (MovingStructure s : anatomy.structures()) {
            if (s.surface().kind() != StructureKind.SKIN && s.surface().kind() != StructureKind.PLEURA) {
                crossings.addAll(crossingsOf(s, entry, end));
            }
            if (s.noGo().isPresent()) {
                double distance = distance(s, entry, end, MAX_DISTANCE_MM);
                if (distance < MAX_DISTANCE_MM) {
                    approaches.add(new Approach(
                            s.surface().name(), s.label(), s.surface().kind(), distance, probe.nearestDepth()));
                }
            }
        }
        approaches.sort(Approach.NEAREST_FIRST);
        double wallDepth = chestWallDepth(entry, end);
        recess(entry, end, wallDepth, crossings).ifPresent(crossings::add);
        crossings.sort(Comparator.comparingDouble(Crossing::fromMm).thenComparing(Crossing::name));
        double groove = MAX_DISTANCE_MM;
        String grooveRib = "";
        for (CostalGroove g : anatomy.grooves()) {
            double d = g.distance(entry, end, probe, groove);
            if (d < groove) {
                groove = d;
                grooveRib = g.rib().label();
            }
        }
        return new PathAnalysis(
                anatomy.timeS(),
                Vectors.distance(entry, end),
                List.copyOf(crossings),
                ways.of(entry, end, wallDepth),
                List.copyOf(approaches),
                groove,
                grooveRib,
                capsuleAngle(entry, end),
                NoGoZone.of(touched(entry, end)));
    }

    /** The way by which a path enters the body. */
    EntryWay way(double[] entry, double[] end) {
        return ways.of(entry, end, chestWallDepth(entry, end));
    }

    /** The segments of a path inside a structure. */
    public List<Crossing> crossingsOf(MovingStructure s, double[] entry, double[] end) {
        int count = intersect(s, entry, end);
        List<Crossing> crossings = new ArrayList<>();
        int depth = 0;
        double since = 0;
        for (int i = 0; i < count; i++) {
            if (probe.facing(i) > 0) {
                since = depth == 0 ? probe.depth(i) : since;
                depth++;
            } else {
                depth = Math.max(0, depth - 1);
                if (depth == 0) {
                    crossings.add(crossing(s, since, probe.depth(i)));
                    since = probe.depth(i);
                }
            }
        }
        if (depth > 0) {
            crossings.add(crossing(s, since, probe.length()));
        }
        return crossings;
    }

    private static Crossing crossing(MovingStructure s, double from, double to) {
        return new Crossing(s.surface().name(), s.label(), s.surface().kind(), from, to);
    }

    private int intersect(MovingStructure s, double[] entry, double[] end) {
        if (s.boxDistance(entry, end) > 0) {
            return 0;
        }
        s.setProbe(entry, end, probe);
        return probe.intersect(s.tree());
    }

    /**
     * Distance between a path and a structure, at most {@code limit}. Afterwards the probe holds the depth of the
     * nearest point.
     */
    private double distance(MovingStructure s, double[] entry, double[] end, double limit) {
        if (s.boxDistance(entry, end) >= limit) {
            return limit;
        }
        s.setProbe(entry, end, probe);
        return probe.distance(s.tree(), limit);
    }

    /** Zones that a path touches, as bits of {@link NoGoZone}. */
    int touched(double[] entry, double[] end) {
        int bits = 0;
        for (MovingStructure s : anatomy.hazards()) {
            int bit = s.noGo().orElseThrow().bit();
            if ((bits & bit) == 0 && distance(s, entry, end, radius) < radius) {
                bits |= bit;
            }
        }
        double zone = CostalGroove.NEUROVASCULAR_ZONE_MM;
        if (anatomy.grooves().stream().anyMatch(g -> g.distance(entry, end, probe, zone) < zone)) {
            bits |= NoGoZone.VESSELS.bit();
        }
        return pleuralDepth(entry, end) < NONE ? bits | NoGoZone.PLEURA.bit() : bits;
    }

    /**
     * Margin of a path to the avoided zones. The pleural recess has no distance: it is crossed, which leaves no margin,
     * or not.
     */
    public Margin margin(double[] entry, double[] end, Set<NoGoZone> avoided) {
        if (avoided.contains(NoGoZone.PLEURA) && pleuralDepth(entry, end) < NONE) {
            return new Margin(0, "");
        }
        double margin = MAX_DISTANCE_MM;
        String nearest = "";
        for (MovingStructure s : anatomy.hazards()) {
            if (avoided.contains(s.noGo().orElseThrow())) {
                double d = distance(s, entry, end, margin + radius);
                if (d < margin + radius) {
                    margin = d - radius;
                    nearest = s.surface().name();
                }
            }
        }
        if (avoided.contains(NoGoZone.VESSELS)) {
            double zone = CostalGroove.NEUROVASCULAR_ZONE_MM;
            for (CostalGroove g : anatomy.grooves()) {
                double d = g.distance(entry, end, probe, margin + zone);
                if (d < margin + zone) {
                    margin = d - zone;
                    nearest = MovingAnatomy.VESSELS_PREFIX + g.rib().surface().name();
                }
            }
        }
        return new Margin(Math.max(0, margin), nearest);
    }

    /** Depth at which a path crosses the pleura; infinite if it does not. */
    private double pleuralDepth(double[] entry, double[] end) {
        return Math.min(surfaceDepth(entry, end), recessDepth(entry, end));
    }

    private double surfaceDepth(double[] entry, double[] end) {
        double first = NONE;
        for (MovingStructure pleura : anatomy.pleurae()) {
            int count = intersect(pleura, entry, end);
            for (int i = 0; i < count; i++) {
                first = Math.min(first, probe.depth(i));
            }
        }
        return first;
    }

    /**
     * Depth at which a path enters the diaphragm from the pleural recess, on a side without a surface of the pleura.
     */
    private double recessDepth(double[] entry, double[] end) {
        if (!anatomy.hasRuledPleura()) {
            return NONE;
        }
        MovingStructure diaphragm = anatomy.diaphragm().orElseThrow();
        int count = intersect(diaphragm, entry, end);
        for (int i = 0; i < count; i++) {
            double[] at = MeshMeasure.centroid(diaphragm.surface().rest(), probe.triangle(i));
            if (probe.facing(i) > 0 && anatomy.bordersRuledRecess(at)) {
                return probe.depth(i);
            }
        }
        return NONE;
    }

    /** The segment of a path between chest wall and diaphragm that contains no lung. */
    private Optional<Crossing> recess(double[] entry, double[] end, double wallDepth, List<Crossing> crossings) {
        double pleural = pleuralDepth(entry, end);
        if (pleural == NONE) {
            return Optional.empty();
        }
        if (surfaceDepth(entry, end) == pleural) {
            double to = crossings.stream()
                    .filter(c -> c.kind() == StructureKind.DIAPHRAGM || c.kind() == StructureKind.LUNG)
                    .filter(c -> c.toMm() > pleural)
                    .mapToDouble(c -> Math.max(pleural, c.fromMm()))
                    .min()
                    .orElse(Vectors.distance(entry, end));
            return Optional.of(recess(pleural, to));
        }
        double from = Double.isNaN(wallDepth) ? pleural : Math.min(wallDepth, pleural);
        for (Crossing c : crossings) {
            if (c.kind() == StructureKind.LUNG && c.fromMm() < pleural) {
                from = Math.max(from, Math.min(c.toMm(), pleural));
            }
        }
        return Optional.of(recess(from, pleural));
    }

    private static Crossing recess(double from, double to) {
        return new Crossing(Crossing.RECESS, "pleural recess", StructureKind.OTHER, from, to);
    }

    /** Depth of the path's nearest point to a rib or costal cartilage; NaN if none is in range. */
    private double chestWallDepth(double[] entry, double[] end) {
        double best = MAX_DISTANCE_MM;
        double depth = Double.NaN;
        for (MovingStructure s : anatomy.hazards()) {
            double d = isCage(s) ? distance(s, entry, end, best) : best;
            if (d < best) {
                best = d;
                depth = probe.nearestDepth();
            }
        }
        return depth;
    }

    static boolean isCage(MovingStructure s) {
        StructureKind kind = s.surface().kind();
        return kind == StructureKind.RIB || kind == StructureKind.COSTAL_CARTILAGE;
    }

    /**
     * Angle between a path and the liver surface at the first entry, degrees; NaN if the path does not enter the liver.
     */
    double capsuleAngle(double[] entry, double[] end) {
        MovingStructure liver = anatomy.liver();
        int count = intersect(liver, entry, end);
        for (int i = 0; i < count; i++) {
            if (probe.facing(i) > 0) {
                int[] t = liver.surface().rest().triangles();
                int c = 3 * probe.triangle(i);
                double[] normal = new double[3];
                Triangles.cross(liver.positions(), 3 * t[c], 3 * t[c + 1], 3 * t[c + 2], normal);
                double[] path = Vectors.subtract(liver.toLocal(end), liver.toLocal(entry));
                return 90 - Math.min(90, Vectors.angleDeg(Vectors.subtract(new double[3], path), normal));
            }
        }
        return Double.NaN;
    }
}
