package org.phrenic.patient.segmentation;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.TreeMap;
import java.util.stream.IntStream;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.StructureName;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.label.LabelTable;

/**
 * Numbers of ribs. Where a label holds parts of two ribs or names a rib of the other side, labels leave out a number
 * between two ribs that follow each other beside thoracic vertebrae, or all ribs share one label, the connected ribs
 * are numbered from top to bottom on each side. Without thoracic vertebrae they are counted from the first or the last
 * ({@link CutRibCount}). The numbers are otherwise those of least cost: the height of a rib's vertebral end above or
 * below the vertebra of its number, the share of its voxels that carry another number, and numbers left out. Of a rib
 * whose vertebral end is cut off the vertebra lies higher than what is left. Where no vertebra above the twelfth is
 * shown, the height of the lowest rib alone tells its number.
 */
final class RibNumbering {
    static final int RIBS = 12;
    /** Difference in height that costs as much as no vote at all, mm: the height of a thoracic vertebra. */
    static final double VERTEBRA_MM = 25;
    /** Weight of the labels' numbers where vertebrae are known. */
    private static final double VOTE = 0.5;
    /** Cost of a number without a rib between two ribs. */
    private static final double GAP = 0.3;
    /** Weight of the height above what is left of a rib whose vertebral end is cut off. */
    private static final double ABOVE_CUT = 0.2;

    private static final String BY_VERTEBRAE = "by their vertebrae";

    private final Segmentation s;
    /** Whether ribs share a label. */
    private final boolean isCommon;

    private final RibComponents components;
    private final RibSides sides;
    private final VertebraHeights vertebrae;

    private RibNumbering(Segmentation s, RibComponents components) {
        this.s = s;
        this.components = components;
        isCommon = isCommon(s);
        sides = new RibSides(s, components.ribs());
        vertebrae = new VertebraHeights(s);
    }

    /**
     * Numbers the ribs where labels do not.
     *
     * @return a note if ribs were numbered
     * @throws BadInputException with a message without the file's name, if the ribs cannot be told apart
     */
    static Optional<String> check(Segmentation s) {
        RibComponents components = components(s, isCommon(s));
        Optional<String> reason = reason(s, components);
        if (reason.isEmpty()) {
            components.relabelBleeding();
            return Optional.empty();
        }
        return Optional.of(
                isCommon(s) ? new RibNumbering(s, components).renumber(reason.get()) : renumber(s, reason.get()));
    }

    /**
     * Numbers the ribs anew.
     *
     * @param found begins the note
     * @return a note
     */
    static String renumber(Segmentation s, String found) {
        return new RibNumbering(s, components(s, true)).renumber(found);
    }

    private static boolean isCommon(Segmentation s) {
        return s.names().stream().anyMatch(LabelTable::isRibs);
    }

    private static RibComponents components(Segmentation s, boolean parted) {
        byte[] group = new byte[LabelGrid.MAX_BYTE_LABEL + 1];
        for (String name : s.names()) {
            boolean rib = LabelTable.isRibs(name)
                    || StructureName.parse(name)
                            .filter(n -> n.kind() == StructureKind.RIB)
                            .isPresent();
            group[s.find(name)] = (byte) (rib ? 1 : 0);
        }
        return new RibComponents(s, group, parted);
    }

    /** Why the labels do not number the ribs; empty if they do. */
    private static Optional<String> reason(Segmentation s, RibComponents components) {
        if (isCommon(s)) {
            return Optional.of("ribs");
        }
        Optional<Integer> divided = components.dividedSegment();
        if (divided.isPresent()) {
            return Optional.of("label " + RibSides.label(s, divided.get()) + " holds parts of two ribs");
        }
        return new RibSides(s, components.ribs()).contradiction();
    }

    private String renumber(String found) {
        List<RibComponents.Rib> ribs = components.ribs();
        if (ribs.isEmpty()) {
            throw new BadInputException(found + ": found no rib, expected some");
        }
        double middle = sides.middle()
                .orElseThrow(() -> new BadInputException(found + ": found neither spine nor sternum between ribs of"
                        + " one label, expected one of them, ribs of both sides, or the names "
                        + LabelTable.RIGHT_RIBS + " and " + LabelTable.LEFT_RIBS));
        VertebralEnd[] ends =
                ribs.stream().map(rib -> vertebralEnd(rib, middle)).toArray(VertebralEnd[]::new);
        List<Side> both = List.of(Side.RIGHT, Side.LEFT);
        List<List<Integer>> onSides = new ArrayList<>();
        int stray = 0;
        for (Side side : both) {
            List<Integer> onSide = new ArrayList<>(IntStream.range(0, ribs.size())
                    .filter(i -> sides.of(ribs.get(i), middle) == side)
                    .boxed()
                    .toList());
            stray += dropStrays(onSide);
            onSides.add(fromTop(onSide, ends));
        }
        String[] nameOf = new String[ribs.size()];
        List<String> numbered = new ArrayList<>();
        OptionalInt[] first = CutRibCount.first(
                s,
                onSides.stream()
                        .map(onSide -> onSide.stream().map(ribs::get).toList())
                        .toList(),
                onSides.stream()
                        .map(onSide ->
                                onSide.stream().mapToDouble(i -> ends[i].z()).toArray())
                        .toList());
        List<String> ways = new ArrayList<>();
        for (int n = 0; n < both.size(); n++) {
            ways.add(way(onSides.get(n).size(), first[n]));
            int[] numbers = numbers(onSides.get(n), ends, first[n], both.get(n), found);
            for (int i = 0; i < numbers.length; i++) {
                String name = name(numbers[i], both.get(n));
                nameOf[onSides.get(n).get(i)] = name;
                numbered.add(name);
            }
        }
        apply(ribs, nameOf);
        return found + ": the " + numbered.size() + " connected ribs are numbered from top to bottom"
                + told(ways)
                + (stray > 0 ? "; " + stray + " parts of ribs away from their label's rib are left out" : "")
                + components.parted();
    }

    /** The ribs of a side from top to bottom. */
    private List<Integer> fromTop(List<Integer> onSide, VertebralEnd[] ends) {
        List<RibComponents.Rib> ribs = components.ribs();
        return onSide.stream()
                .sorted(Comparator.comparingLong((Integer i) -> onSide.stream()
                                .filter(other -> ribs.get(other).heightAbove(ribs.get(i)) > 0)
                                .count())
                        .thenComparingDouble(i -> -ends[i].z()))
                .toList();
    }

    /**
     * Leaves out parts of a side that has more than twelve, the smallest first, as long as another part holds more of
     * their label, which is not the common one; returns how many.
     */
    private int dropStrays(List<Integer> onSide) {
        List<RibComponents.Rib> ribs = components.ribs();
        int before = onSide.size();
        while (onSide.size() > RIBS) {
            Optional<Integer> stray = onSide.stream()
                    .filter(i -> components.isStray(ribs.get(i)))
                    .min(Comparator.comparingInt(i -> ribs.get(i).voxels.size()));
            if (stray.isEmpty()) {
                return before - onSide.size();
            }
            s.write(ribs.get(stray.get()).voxels, 0);
            onSide.remove(stray.get());
        }
        return before - onSide.size();
    }

    /**
     * The end of a rib toward the spine.
     *
     * @param z height, mm
     * @param isCut whether the scan cuts the rib off before it reaches the spine
     */
    private record VertebralEnd(double z, boolean isCut) {}

    /** Name of a rib. */
    static String name(int number, Side side) {
        return String.format(Locale.ROOT, "rib_%02d_%s", number, side == Side.RIGHT ? "R" : "L");
    }

    /** The end of the note: what tells the numbers on the right and on the left. */
    private static String told(List<String> ways) {
        List<String> different =
                ways.stream().filter(way -> !way.isEmpty()).distinct().toList();
        return switch (different.size()) {
            case 0 -> "";
            case 1 -> (different.get(0).equals(BY_VERTEBRAE) ? " " : ", ") + different.get(0);
            default -> ", " + ways.get(0) + " on the right and " + ways.get(1) + " on the left";
        };
    }

    /**
     * What tells the numbers of the ribs of a side; empty if their labels or their count do.
     *
     * @param ribs number of ribs
     * @param first number of the highest one as counted without vertebrae; empty if that is unknown
     */
    private String way(int ribs, OptionalInt first) {
        if (isUnknown(ribs) && first.isPresent() && !vertebrae.showThorax()) {
            return first.getAsInt() == 1 ? "counted from the first" : "counted from the last";
        }
        boolean byVertebrae = ribs > 0 && (vertebrae.showThorax() || (isUnknown(ribs) && vertebrae.areShown()));
        return byVertebrae ? BY_VERTEBRAE : "";
    }

    /** Whether neither labels tell the numbers of so many ribs of a side nor that they are all. */
    private boolean isUnknown(int ribs) {
        return isCommon && ribs > 0 && ribs < RIBS;
    }

    /** The vertebral end of a rib: the part of its posterior half that is nearest to the median plane. */
    private VertebralEnd vertebralEnd(RibComponents.Rib rib, double middle) {
        List<double[]> posterior = VertebraHeights.posterior(s, rib.voxels, rib.centre[1], middle);
        return new VertebralEnd(
                VertebraHeights.endHeight(posterior, rib.voxels.size()).orElse(rib.centre[2]),
                rib.ends != 0 && VertebraHeights.isFarFromSpine(posterior));
    }

    /**
     * Increasing numbers of least total cost for ribs from top to bottom.
     *
     * @param first number of the highest one as counted without vertebrae; empty if that is unknown
     */
    private int[] numbers(List<Integer> ribs, VertebralEnd[] ends, OptionalInt first, Side side, String found) {
        int n = ribs.size();
        if (isUnknown(n) && !vertebrae.showAboveLast() && (first.isPresent() || vertebrae.areShown())) {
            int highest = vertebrae.showThorax() || first.isEmpty() ? byLowest(ribs, ends, side) : first.getAsInt();
            return IntStream.range(0, n).map(i -> highest + i).toArray();
        }
        if (n > RIBS || (isUnknown(n) && !vertebrae.areShown())) {
            throw new BadInputException(found + ", which cannot be told apart: found " + n + " connected ribs on the "
                    + side.name().toLowerCase(Locale.ROOT)
                    + (n > RIBS ? ", expected at most 12" : " and no vertebrae, expected 12, or labelled vertebrae")
                    + components.parted());
        }
        double[][] least = new double[n][RIBS + 1];
        int[][] before = new int[n][RIBS + 1];
        for (int i = 0; i < n; i++) {
            for (int number = i + 1; number <= RIBS - n + i + 1; number++) {
                double cost = cost(ribs.get(i), ends, number, side);
                least[i][number] = i == 0 ? cost : Double.POSITIVE_INFINITY;
                for (int above = i; i > 0 && above < number; above++) {
                    double sum = least[i - 1][above] + GAP * (number - above - 1) + cost;
                    if (sum < least[i][number]) {
                        least[i][number] = sum;
                        before[i][number] = above;
                    }
                }
            }
        }
        int[] numbers = new int[n];
        for (int i = n - 1; i >= 0; i--) {
            numbers[i] = i == n - 1 ? lowest(least[i], n) : before[i + 1][numbers[i + 1]];
        }
        return numbers;
    }

    /**
     * The number of the highest of ribs that follow each other, from the lowest one whose vertebral end the scan shows:
     * how far vertebrae lie from each other above the twelfth is then unknown.
     */
    private int byLowest(List<Integer> ribs, VertebralEnd[] ends, Side side) {
        int n = ribs.size();
        int lowest = IntStream.iterate(n - 1, i -> i >= 0, i -> i - 1)
                .filter(i -> !ends[ribs.get(i)].isCut())
                .findFirst()
                .orElse(n - 1);
        return IntStream.rangeClosed(1, RIBS - n + 1)
                .boxed()
                .min(Comparator.comparingDouble(first -> cost(ribs.get(lowest), ends, first + lowest, side)))
                .orElseThrow();
    }

    /** The number of least cost of the lowest of n ribs. */
    private static int lowest(double[] least, int n) {
        return IntStream.rangeClosed(n, RIBS)
                .boxed()
                .min(Comparator.comparingDouble(number -> least[number]))
                .orElseThrow();
    }

    private double cost(int rib, VertebralEnd[] ends, int number, Side side) {
        int segment = s.find(name(number, side));
        double vote = 1 - (segment > 0 ? components.ribs().get(rib).share(segment) : 0);
        if (!vertebrae.showThorax() && !(isCommon && vertebrae.areShown())) {
            return vote;
        }
        double above = (vertebrae.at(number) - ends[rib].z()) / VERTEBRA_MM;
        return Math.abs(above) * (ends[rib].isCut() && above > 0 ? ABOVE_CUT : 1) + VOTE * vote;
    }

    /**
     * Writes the numbers to the voxels; a part without a number stays left out. A fragment goes to the nearest numbered
     * rib, or is left out if none is near.
     */
    private void apply(List<RibComponents.Rib> ribs, String[] nameOf) {
        List<RibComponents.Rib> left = components.attachFragments(rib -> nameOf[ribs.indexOf(rib)] != null);
        left.forEach(fragment -> s.write(fragment.voxels, 0));
        TreeMap<String, List<Integer>> labels = new TreeMap<>();
        for (int i = 0; i < nameOf.length; i++) {
            if (nameOf[i] == null) {
                continue;
            }
            List<Integer> from = ribs.get(i).segments.keySet().stream()
                    .flatMap(segment -> s.labels(s.names().get(segment - 1)).stream())
                    .distinct()
                    .sorted()
                    .toList();
            labels.put(nameOf[i], from);
        }
        for (int i = 0; i < nameOf.length; i++) {
            if (nameOf[i] != null) {
                s.write(ribs.get(i).voxels, s.segment(nameOf[i]));
            }
        }
        labels.forEach(s::setLabels);
    }
}
