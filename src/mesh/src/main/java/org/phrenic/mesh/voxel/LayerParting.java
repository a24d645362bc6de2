package org.phrenic.mesh.voxel;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.IntStream;
import org.phrenic.engine.math.DisjointSets;
import org.phrenic.mesh.IntList;
import org.phrenic.mesh.Vectors;
import org.phrenic.mesh.voxel.SectionChains.Section;

/**
 * Parts a connected body of voxels that lies about an upright axis in several layers, one above another, which hang
 * together in places: ribs whose front ends share a cartilage under their label. In each direction about the axis the
 * body is one or more sections, which make chains ({@link SectionChains}). The voxels of the places where layers hang
 * together go to the layer from which the fewest steps through the body lead to them.
 */
public final class LayerParting {
    private static final int DIRECTIONS = SectionChains.DIRECTIONS;
    /** First directions of the left half of the body and of the right one: no chain crosses the median plane. */
    private static final List<Integer> HALVES = List.of(DIRECTIONS / 4, 3 * DIRECTIONS / 4);
    /** Share of the directions of a body in which it has two layers from which on it is several. */
    private static final double LAYERED = 0.25;
    /** Least number of such directions. */
    private static final int LEAST_LAYERED = 4;
    /**
     * Difference in distance from the axis over that in height from which on two sections may be of one layer. Of ribs
     * 3 to 12 one above another it is mostly below; a first rib or a last one may end above or below its own middle.
     */
    private static final double OUTWARD = 0.6;
    /** Sections whose mean heights differ by less are of one layer, mm: less than half of the distance of two ribs. */
    private static final double SAME_MM = 9;
    /** Least height of two layers in a direction, mm. */
    private static final double LEAST_MM = 20;
    /** Sections of less than this share of the mean number of voxels in a direction are specks. */
    private static final double SPECK = 0.05;
    /** Least share of the directions of the shorter of two layers that is common to both. */
    private static final double BESIDE = 0.3;
    /** Number of voxels about one, across faces, edges and corners. */
    private static final int NEIGHBOURS = 26;

    /**
     * Layers of a body.
     *
     * @param pieces voxels of each in the order of the volume; the whole body alone if it cannot be parted
     * @param count greatest number of layers in a direction
     * @param joint a voxel in the middle of the places in which layers hang together, mm
     */
    public record Layers(List<IntList> pieces, int count, double[] joint) {}

    private final LabelGrid grid;
    /** Voxels in the order of the volume, their centres (mm) and their directions. */
    private final int[] voxels;

    private final double[][] points;
    private final int[] directions;
    /** Section of each voxel; -1 in a speck. */
    private final int[] sectionOf;

    private final List<Section> sections = new ArrayList<>();

    private LayerParting(LabelGrid grid, IntList body, double[] axis) {
        this.grid = grid;
        voxels = body.toArray();
        points = new double[voxels.length][3];
        directions = new int[voxels.length];
        sectionOf = new int[voxels.length];
        int columns = grid.columns();
        for (int n = 0; n < voxels.length; n++) {
            int row = voxels[n] / columns;
            int slice = row / grid.rows();
            grid.voxelToMm(voxels[n] % columns, row % grid.rows(), slice, points[n]);
            double angle = StrictMath.atan2(points[n][1] - axis[1], points[n][0] - axis[0]);
            directions[n] = Math.min(DIRECTIONS - 1, (int) ((angle + Math.PI) / (2 * Math.PI) * DIRECTIONS));
        }
        if (mayBeLayered()) {
            findSections(axis);
        }
    }

    /**
     * Parts a body into its layers.
     *
     * @param body its voxels in the order of the volume
     * @param axis x and y of the upright axis, mm
     * @return empty if the body has no two layers in a good share of its directions
     */
    public static Optional<Layers> part(LabelGrid grid, IntList body, double[] axis) {
        LayerParting parting = new LayerParting(grid, body, axis);
        if (!parting.isLayered()) {
            return Optional.empty();
        }
        parting.link();
        SectionChains chains = new SectionChains(parting.sections);
        List<IntList> pieces = parting.grown(chains.layers());
        int count = IntStream.range(0, DIRECTIONS).map(parting::layers).max().orElse(0);
        List<LayerParting> layers = pieces.stream()
                .map(piece -> new LayerParting(grid, piece, axis))
                .toList();
        boolean parted = pieces.size() > 1
                && layers.stream().noneMatch(LayerParting::isLayered)
                && (pieces.size() <= count || layers.stream().allMatch(layer -> layer.isBesideAll(layers)));
        return Optional.of(new Layers(parted ? pieces : List.of(body), count, parting.joint(chains)));
    }

    /** Whether a layer lies above or below all others: two pieces of one would lie end to end. */
    private boolean isBesideAll(List<LayerParting> others) {
        long own = Arrays.stream(directions).distinct().count();
        return others.stream().allMatch(other -> {
            long all = IntStream.concat(Arrays.stream(directions), Arrays.stream(other.directions))
                    .distinct()
                    .count();
            long its = Arrays.stream(other.directions).distinct().count();
            return own + its - all >= BESIDE * Math.min(own, its);
        });
    }

    /** Whether the body is high enough for two layers in enough directions. */
    private boolean mayBeLayered() {
        double[] low = new double[DIRECTIONS];
        double[] high = new double[DIRECTIONS];
        Arrays.fill(low, Double.POSITIVE_INFINITY);
        Arrays.fill(high, Double.NEGATIVE_INFINITY);
        for (int n = 0; n < voxels.length; n++) {
            low[directions[n]] = Math.min(low[directions[n]], points[n][2]);
            high[directions[n]] = Math.max(high[directions[n]], points[n][2]);
        }
        long tall = IntStream.range(0, DIRECTIONS)
                .filter(d -> high[d] - low[d] > LEAST_MM)
                .count();
        return tall >= LAYERED * Arrays.stream(directions).distinct().count();
    }

    /** Finds the sections: connected voxels of a direction, and such at one height as well. */
    private void findSections(double[] axis) {
        int[] parent = DisjointSets.singletons(voxels.length);
        for (int n = 0; n < voxels.length; n++) {
            for (int step = 0; step < NEIGHBOURS / 2; step++) {
                int other = neighbour(n, step);
                if (other >= 0 && directions[other] == directions[n]) {
                    DisjointSets.unionToLower(parent, n, other);
                }
            }
        }
        TreeMap<Integer, Section> byRoot = new TreeMap<>();
        for (int n = 0; n < voxels.length; n++) {
            int direction = directions[n];
            Section section = byRoot.computeIfAbsent(DisjointSets.find(parent, n), root -> new Section(direction));
            double radius = StrictMath.hypot(points[n][0] - axis[0], points[n][1] - axis[1]);
            section.size++;
            section.height += (points[n][2] - section.height) / section.size;
            section.radius += (radius - section.radius) / section.size;
        }
        double least =
                SPECK * voxels.length / Arrays.stream(directions).distinct().count();
        TreeMap<Integer, Integer> numberOf = new TreeMap<>();
        byRoot.forEach((root, section) -> numberOf.put(root, section.size < least ? -1 : number(section)));
        Arrays.setAll(sectionOf, n -> numberOf.get(DisjointSets.find(parent, n)));
    }

    /** Enters a section; returns its number, or that of one at its height in the same direction. */
    private int number(Section section) {
        for (int number = 0; number < sections.size(); number++) {
            Section other = sections.get(number);
            if (other.direction == section.direction && Math.abs(other.height - section.height) < SAME_MM) {
                other.size += section.size;
                other.height += (section.height - other.height) * section.size / other.size;
                other.radius += (section.radius - other.radius) * section.size / other.size;
                return number;
            }
        }
        sections.add(section);
        return sections.size() - 1;
    }

    /** Index of the voxel at a step, -1 for none; the second half of the steps go back over the first. */
    private int neighbour(int n, int step) {
        int at = step < NEIGHBOURS / 2 ? NEIGHBOURS / 2 + 1 + step : step - NEIGHBOURS / 2;
        int row = voxels[n] / grid.columns();
        int i = voxels[n] % grid.columns() + at % 3 - 1;
        int j = row % grid.rows() + at / 3 % 3 - 1;
        int k = row / grid.rows() + at / 9 - 1;
        boolean inside = i >= 0 && i < grid.columns() && j >= 0 && j < grid.rows() && k >= 0 && k < grid.slices();
        return inside ? Math.max(-1, Arrays.binarySearch(voxels, i + grid.columns() * (j + grid.rows() * k))) : -1;
    }

    private boolean isLayered() {
        long layered = IntStream.range(0, DIRECTIONS).filter(d -> layers(d) > 1).count();
        return layered >= LEAST_LAYERED
                && layered >= LAYERED * Arrays.stream(directions).distinct().count();
    }

    /** Number of layers in a direction, from the lowest on. */
    private int layers(int direction) {
        List<Section> layers = new ArrayList<>();
        sections.stream()
                .filter(section -> section.direction == direction)
                .sorted(Comparator.comparingDouble(section -> section.height))
                .filter(section -> layers.stream()
                        .noneMatch(layer ->
                                OUTWARD * (section.height - layer.height) < Math.abs(section.radius - layer.radius)))
                .forEach(layers::add);
        return layers.size();
    }

    /** Finds which sections of neighbouring directions touch. */
    private void link() {
        for (int n = 0; n < voxels.length; n++) {
            int next = (directions[n] + 1) % DIRECTIONS;
            for (int step = 0; step < NEIGHBOURS && sectionOf[n] >= 0 && !HALVES.contains(next); step++) {
                int other = neighbour(n, step);
                if (other >= 0 && sectionOf[other] >= 0 && directions[other] == next) {
                    sections.get(sectionOf[n]).after.merge(sectionOf[other], 1, Integer::sum);
                    sections.get(sectionOf[other]).before.merge(sectionOf[n], 1, Integer::sum);
                }
            }
        }
    }

    /** The voxels of each layer, grown into what belongs to none. */
    private List<IntList> grown(int[] layerOfSection) {
        int[] layer = new int[voxels.length];
        int[] queue = new int[voxels.length];
        int length = 0;
        for (int n = 0; n < voxels.length; n++) {
            layer[n] = sectionOf[n] < 0 ? 0 : layerOfSection[sectionOf[n]];
            if (layer[n] > 0) {
                queue[length++] = n;
            }
        }
        for (int at = 0; at < length; at++) {
            for (int step = 0; step < NEIGHBOURS; step++) {
                int other = neighbour(queue[at], step);
                if (other >= 0 && layer[other] == 0) {
                    layer[other] = layer[queue[at]];
                    queue[length++] = other;
                }
            }
        }
        TreeMap<Integer, IntList> pieces = new TreeMap<>();
        for (int n = 0; n < voxels.length; n++) {
            pieces.computeIfAbsent(layer[n], number -> new IntList()).add(voxels[n]);
        }
        return List.copyOf(pieces.values());
    }

    /** Of the voxels in which layers hang together, or all if they do nowhere, the one nearest to their centre, mm. */
    private double[] joint(SectionChains chains) {
        List<double[]> joint = IntStream.range(0, voxels.length)
                .filter(n -> sectionOf[n] >= 0 && chains.isKnot(sectionOf[n]))
                .mapToObj(n -> points[n])
                .toList();
        List<double[]> of = joint.isEmpty() ? List.of(points) : joint;
        double[] centre = new double[3];
        for (double[] point : of) {
            Arrays.setAll(centre, row -> centre[row] + point[row] / of.size());
        }
        return of.stream()
                .min(Comparator.comparingDouble(point -> Vectors.distance(point, centre)))
                .orElseThrow();
    }
}
