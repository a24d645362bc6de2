package org.phrenic.patient.numbering;

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
import org.phrenic.patient.numbering.VertebraHeights.VertebralEnd;
import org.phrenic.patient.segmentation.Segmentation;

/**
 * Numbers of ribs. Where a label holds parts of two ribs or names a rib of the other side, labels leave out a number
 * between two ribs that follow each other beside thoracic vertebrae, or all ribs share one label, the connected ribs
 * are numbered from top to bottom on each side. Without thoracic vertebrae they are counted from the first or the last
 * ({@link CutRibCount}). The numbers are otherwise those of least cost: the height of a rib's vertebral end above or
 * below the vertebra of its number, the share of its voxels that carry another number, and numbers left out. A stray
 * part under the label of a rib is left out where the scan cuts off ribs of its side and they would otherwise leave the
 * numbers of their labels. Of a rib whose vertebral end is cut off the vertebra lies higher than what is left. Where no
 * vertebra above the twelfth is shown, the height of the lowest rib alone tells its number.
 */
final class RibNumbering {
    static final int RIBS = 12;
    /** Difference in height that costs as much as no vote at all, mm: the height of a thoracic vertebra. */
    static final double VERTEBRA_MM = 25;
    /**
     * Mean height of a rib above another below which the last ribs, short and steep ones, may lie in any order: 5 mm in
     * the scanned man, -9 mm where he is turned by 20 degrees.
     */
    private static final double LEVEL_MM = 12;
    /** Difference in height of two vertebral ends that are not of one vertebra, mm. */
    private static final double APART_MM = 8;

    /** Smallest volume of small parts that a note states, ml. */
    private static final double LEAST_NOTED_ML = 0.1;

    private static final String BY_VERTEBRAE = "by their vertebrae";

    private final Segmentation s;
    /** Whether ribs share a label. */
    private final boolean isCommon;

    private final RibComponents components;
    private final RibSides sides;
    private final VertebraHeights vertebrae;
    private final RibCosts costs;

    private RibNumbering(Segmentation s, RibComponents components) {
        this.s = s;
        this.components = components;
        isCommon = isCommon(s);
        sides = new RibSides(s, components.ribs());
        vertebrae = new VertebraHeights(s);
        costs = new RibCosts(s, components, vertebrae);
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
        VertebralEnd[] ends = ribs.stream()
                .map(rib -> VertebraHeights.vertebralEnd(s, rib, middle))
                .toArray(VertebralEnd[]::new);
        List<Side> both = List.of(Side.RIGHT, Side.LEFT);
        List<List<Integer>> onSides = new ArrayList<>();
        for (Side side : both) {
            List<Integer> onSide = new ArrayList<>(IntStream.range(0, ribs.size())
                    .filter(i -> sides.of(ribs.get(i), middle) == side)
                    .boxed()
                    .toList());
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
        List<String> leftOut = new ArrayList<>();
        for (int n = 0; n < both.size(); n++) {
            ways.add(way(onSides.get(n).size(), first[n]));
            int[] numbers = numbers(onSides.get(n), ends, first[n], both.get(n), found);
            for (int i = 0; i < numbers.length; i++) {
                int rib = onSides.get(n).get(i);
                if (numbers[i] == 0) {
                    leftOut.add(leftOut(ribs.get(rib), ends[rib].z(), both.get(n)));
                    continue;
                }
                String name = name(numbers[i], both.get(n));
                nameOf[rib] = name;
                numbered.add(name);
            }
        }
        double rest = apply(ribs, nameOf);
        return found + ": the " + numbered.size() + " connected ribs are numbered from top to bottom"
                + told(ways)
                + (leftOut.isEmpty()
                        ? ""
                        : "; left out, away from the rib of their label: " + String.join(", ", leftOut))
                + (rest < LEAST_NOTED_ML
                        ? ""
                        : String.format(Locale.ROOT, "; left out, in small parts away from all ribs: %.1f ml", rest))
                + components.parted();
    }

    /** The ribs of a side from top to bottom. */
    private List<Integer> fromTop(List<Integer> onSide, VertebralEnd[] ends) {
        return onSide.stream()
                .sorted(Comparator.comparingLong((Integer i) -> onSide.stream()
                                .filter(other -> isAbove(other, i, ends))
                                .count())
                        .thenComparingDouble(i -> -ends[i].z()))
                .toList();
    }

    /** Whether a rib lies above another in the directions of both, or at the spine where these hardly tell it. */
    private boolean isAbove(int rib, int other, VertebralEnd[] ends) {
        double above = components.ribs().get(rib).heightAbove(components.ribs().get(other));
        double atSpine = ends[rib].z() - ends[other].z();
        boolean told = ends[rib].isWhole() && ends[other].isWhole() && Math.abs(atSpine) > APART_MM;
        return (told && Math.abs(above) < LEVEL_MM ? atSpine : above) > 0;
    }

    /** Clears a part; returns words for it. */
    private String leftOut(RibComponents.Rib part, double z, Side side) {
        s.write(part.voxels, 0);
        return "a part of label " + RibSides.label(s, part.dominantSegment())
                + vertebrae.nameAt(z).map(name -> " at the height of " + name).orElse("") + " on the "
                + side.name().toLowerCase(Locale.ROOT);
    }

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

    /**
     * Increasing numbers for ribs from top to bottom; 0 for a part that is left out. Of more than twelve as few as
     * possible are; of others those that {@link RibCosts#numbers} tells.
     *
     * @param first number of the highest one as counted without vertebrae; empty if that is unknown
     */
    private int[] numbers(List<Integer> ribs, VertebralEnd[] ends, OptionalInt first, Side side, String found) {
        int n = ribs.size();
        if (isUnknown(n) && !vertebrae.showAboveLast() && (first.isPresent() || vertebrae.areShown())) {
            int highest =
                    vertebrae.showThorax() || first.isEmpty() ? costs.byLowest(ribs, ends, side) : first.getAsInt();
            return IntStream.range(0, n).map(i -> highest + i).toArray();
        }
        List<RibComponents.Rib> all = components.ribs();
        int least = n
                - (int) ribs.stream()
                        .filter(i -> components.isStray(all.get(i), 1))
                        .count();
        if (least > RIBS || (isUnknown(n) && !vertebrae.areShown())) {
            throw new BadInputException(found + ", which cannot be told apart: found "
                    + (least > RIBS ? least : n) + " connected ribs on the "
                    + side.name().toLowerCase(Locale.ROOT)
                    + (least > RIBS ? ", expected at most 12" : " and no vertebrae, expected 12, or labelled vertebrae")
                    + components.parted());
        }
        return costs.numbers(ribs, ends, side);
    }

    /**
     * Writes the numbers to the voxels; a part without a number stays left out. A fragment goes to the nearest numbered
     * rib, or is left out if none is near.
     *
     * @return volume of what is left out, ml
     */
    private double apply(List<RibComponents.Rib> ribs, String[] nameOf) {
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
        return s.grid()
                .volumeMl(left.stream().mapToInt(part -> part.voxels.size()).sum());
    }
}
