package org.phrenic.mesh.voxel;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.phrenic.engine.math.DisjointSets;

/**
 * Chains of the sections of a body in the directions about an axis ({@link LayerParting}). A section that touches two
 * of a neighbouring direction is a fork. Chains between forks are layers, but for short ones that hang on one fork and
 * for those into which several run; a layer goes on beyond a fork in the chain that is nearest in height.
 */
final class SectionChains {
    /** Number of sections of a chain below which it is a spur, or too short for a layer. */
    private static final int SHORT = 4;
    /** A chain into which several run is common to them if it is shorter than this share of the longest. */
    private static final double COMMON = 0.5;
    /** Share of the widest contact of both below which two sections only brush against each other. */
    private static final double BRUSH = 0.25;

    /** Sections over which the slope at the end of a chain is taken. */
    private static final int SLOPE = 4;
    /** Greatest distance half way between the ends of chains in line, mm: less than half of that of two ribs. */
    private static final double IN_LINE_MM = 9;
    /** Number of directions in a turn. */
    static final int DIRECTIONS = 72;

    /** Voxels of the body in one direction that are connected there, or nearly so. */
    static final class Section {
        final int direction;
        int size;
        /** Mean height and distance from the axis, mm. */
        double height;

        double radius;
        /** Width of the contact with sections of the direction before and of the one after, by their numbers. */
        final TreeMap<Integer, Integer> before = new TreeMap<>();

        final TreeMap<Integer, Integer> after = new TreeMap<>();

        Section(int direction) {
            this.direction = direction;
        }

        boolean isFork() {
            return before.size() > 1 || after.size() > 1;
        }
    }

    /**
     * An end of a chain at a knot of forks.
     *
     * @param isBefore whether the chain lies before the knot
     * @param last its section there
     * @param slope its slope there, mm per direction
     */
    private record End(int chain, int knot, boolean isBefore, Section last, double slope) {
        /** Difference in height half way to the end of a chain on the other side of the knot, mm. */
        double missedBy(End after) {
            double half = 0.5 * Math.floorMod(after.last.direction - last.direction, DIRECTIONS);
            return Math.abs(last.height + half * slope - after.last.height + half * after.slope);
        }
    }

    private final List<Section> sections;
    private final boolean[] isSpur;
    /** Sections in which layers hang together. */
    private final boolean[] isKnot;
    /** Lowest number of a section in the chain of each; -1 in knots and spurs. */
    private final int[] chain;

    SectionChains(List<Section> sections) {
        this.sections = sections;
        isSpur = new boolean[sections.size()];
        isKnot = new boolean[sections.size()];
        chain = new int[sections.size()];
        dropBrushing();
        findChains();
        while (leaveOutSpur()) {
            findChains();
        }
        List<End> ends = ends();
        for (End end : ends) {
            if (isCommon(end, ends)) {
                IntStream.range(0, chain.length)
                        .filter(member -> chain[member] == end.chain())
                        .forEach(member -> isKnot[member] = true);
            }
        }
        for (int number = 0; number < chain.length; number++) {
            chain[number] = isKnot[number] ? -1 : chain[number];
        }
    }

    private void dropBrushing() {
        for (int number = 0; number < sections.size(); number++) {
            Section section = sections.get(number);
            for (int other : List.copyOf(section.after.keySet())) {
                int contact = section.after.get(other);
                TreeMap<Integer, Integer> back = sections.get(other).before;
                if (contact < BRUSH * widest(section.after) && contact < BRUSH * widest(back)) {
                    section.after.remove(other);
                    back.remove(number);
                }
            }
        }
    }

    private static int widest(Map<Integer, Integer> contacts) {
        return contacts.values().stream().mapToInt(Integer::intValue).max().orElse(0);
    }

    /** Joins the sections between forks to chains. */
    private void findChains() {
        for (int number = 0; number < chain.length; number++) {
            isKnot[number] = sections.get(number).isFork();
            chain[number] = number;
        }
        for (int number = 0; number < chain.length; number++) {
            for (int other : sections.get(number).after.keySet()) {
                if (!isKnot[number] && !isKnot[other]) {
                    DisjointSets.unionToLower(chain, number, other);
                }
            }
        }
        for (int number = 0; number < chain.length; number++) {
            chain[number] = isSpur[number] || isKnot[number] ? -1 : DisjointSets.find(chain, number);
        }
    }

    private int[] members(int root) {
        return IntStream.range(0, chain.length)
                .filter(number -> chain[number] == root)
                .toArray();
    }

    /** Leaves out a short chain that hangs on one fork, if there is one. */
    private boolean leaveOutSpur() {
        for (int root = 0; root < chain.length; root++) {
            int[] members = chain[root] == root ? members(root) : new int[0];
            TreeSet<Integer> forks = new TreeSet<>();
            for (int member : members) {
                forks.addAll(sections.get(member).before.keySet());
                forks.addAll(sections.get(member).after.keySet());
            }
            forks.removeIf(section -> !isKnot[section]);
            if (forks.size() == 1 && members.length < SHORT) {
                Arrays.stream(members).forEach(this::leaveOut);
                return true;
            }
        }
        return false;
    }

    private void leaveOut(int number) {
        Section spur = sections.get(number);
        spur.before.keySet().forEach(other -> sections.get(other).after.remove(number));
        spur.after.keySet().forEach(other -> sections.get(other).before.remove(number));
        spur.before.clear();
        spur.after.clear();
        isSpur[number] = true;
    }

    /** The ends of chains at knots, which are sections in which layers hang together and that touch. */
    private List<End> ends() {
        int[] knot = DisjointSets.singletons(chain.length);
        for (int number = 0; number < chain.length; number++) {
            for (int other : sections.get(number).after.keySet()) {
                if (isKnot[number] && isKnot[other]) {
                    DisjointSets.unionToLower(knot, number, other);
                }
            }
        }
        List<End> ends = new ArrayList<>();
        for (int number = 0; number < chain.length; number++) {
            for (int side = 0; side < 2 && chain[number] >= 0; side++) {
                Section section = sections.get(number);
                for (int other : side == 0 ? section.after.keySet() : section.before.keySet()) {
                    if (isKnot[other]) {
                        ends.add(new End(
                                chain[number],
                                DisjointSets.find(knot, other),
                                side == 0,
                                section,
                                slope(number, side == 0)));
                    }
                }
            }
        }
        return ends;
    }

    /** Slope of a chain from an end some sections inward, mm per direction; 0 of a single section. */
    private double slope(int end, boolean inwardIsBefore) {
        int at = end;
        int steps = 0;
        while (steps < SLOPE) {
            Section section = sections.get(at);
            TreeMap<Integer, Integer> inward = inwardIsBefore ? section.before : section.after;
            if (inward.size() != 1 || chain[inward.firstKey()] != chain[end]) {
                break;
            }
            at = inward.firstKey();
            steps++;
        }
        double rise = sections.get(end).height - sections.get(at).height;
        return steps == 0 ? 0 : (inwardIsBefore ? rise : -rise) / steps;
    }

    /** Whether several chains run into a short one. */
    private boolean isCommon(End end, List<End> ends) {
        List<End> here =
                ends.stream().filter(other -> other.knot() == end.knot()).toList();
        List<End> opposite = here.stream()
                .filter(other -> other.isBefore() != end.isBefore())
                .toList();
        int longest = opposite.stream()
                .mapToInt(other -> members(other.chain()).length)
                .max()
                .orElse(0);
        return opposite.size() > here.size() - opposite.size() && members(end.chain()).length < COMMON * longest;
    }

    /** Number of the layer of each section, from 1; 0 where layers hang together and in spurs. */
    int[] layers() {
        int[] parent = DisjointSets.singletons(chain.length);
        Map<Integer, List<End>> knots =
                ends().stream().collect(Collectors.groupingBy(End::knot, TreeMap::new, Collectors.toList()));
        knots.values().forEach(knot -> match(knot, parent));
        TreeMap<Integer, Integer> lengths = new TreeMap<>();
        for (int root : chain) {
            if (root >= 0) {
                lengths.merge(DisjointSets.find(parent, root), 1, Integer::sum);
            }
        }
        lengths.values().removeIf(length -> length < SHORT);
        List<Integer> roots = List.copyOf(lengths.keySet());
        return Arrays.stream(chain)
                .map(root -> root < 0 ? 0 : roots.indexOf(DisjointSets.find(parent, root)) + 1)
                .toArray();
    }

    /**
     * Unites the chains that go on beyond a knot: from top to bottom if as many leave it as run into it, else those
     * whose heights, continued toward each other, meet half way.
     */
    private static void match(List<End> knot, int[] parent) {
        List<End> before = fromTop(knot, true);
        List<End> after = fromTop(knot, false);
        List<End[]> pairs = new ArrayList<>();
        for (int n = 0; n < before.size(); n++) {
            for (int m = 0; m < after.size(); m++) {
                boolean fits =
                        before.size() == after.size() ? n == m : before.get(n).missedBy(after.get(m)) < IN_LINE_MM;
                if (fits) {
                    pairs.add(new End[] {before.get(n), after.get(m)});
                }
            }
        }
        pairs.sort(Comparator.comparingDouble(pair -> pair[0].missedBy(pair[1])));
        while (!pairs.isEmpty()) {
            End[] nearest = pairs.get(0);
            DisjointSets.unionToLower(parent, nearest[0].chain(), nearest[1].chain());
            pairs.removeIf(pair -> pair[0].equals(nearest[0]) || pair[1].equals(nearest[1]));
        }
    }

    private static List<End> fromTop(List<End> knot, boolean before) {
        return knot.stream()
                .filter(end -> end.isBefore() == before)
                .sorted(Comparator.comparingDouble(end -> -end.last().height))
                .toList();
    }

    /** Whether layers hang together in a section. */
    boolean isKnot(int section) {
        return isKnot[section];
    }
}
