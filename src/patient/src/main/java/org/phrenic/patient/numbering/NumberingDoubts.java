package org.phrenic.patient.numbering;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureName;
import org.phrenic.patient.segmentation.Segmentation;
import org.phrenic.patient.segmentation.Specks;

/**
 * Doubts on the numbers of ribs and vertebrae, which change nothing: a number that is left out in the spine, one
 * vertebra under two labels, two under one, and ribs of a side one vertebra off those of the other. Of which vertebrae
 * the ribs are is seen in the heights of their ends, and in the vertebrae that these lie nearest to.
 */
public final class NumberingDoubts {
    private static final int FIRST = RibDeviations.FIRST_ABOVE;
    private static final int LAST = StructureName.FIRST_LUMBAR + 3;
    /** Least height of two vertebrae under one label over that of their neighbours. */
    private static final double TALL = 1.6;
    /** Least distance of the ends of two ribs between which one ends, in distances of vertebrae. */
    private static final double TWO_APART = 1.65;

    private final RibDeviations ribs;
    private final VertebraVoxels vertebrae;
    private final VertebraHeights height;

    private NumberingDoubts(Segmentation s) {
        Specks specks = Specks.ofBones(s);
        ribs = new RibDeviations(s, specks);
        vertebrae = new VertebraVoxels(s, ribs, specks);
        height = new VertebraHeights(s, specks);
    }

    /** Returns a note on each doubt. To be called when ribs and vertebrae have their last numbers and voxels. */
    public static List<String> find(Segmentation s) {
        NumberingDoubts doubts = new NumberingDoubts(s);
        List<String> notes = new ArrayList<>();
        if (doubts.ribs.areKnown()) {
            for (int level = FIRST + 1; level <= RibNumbering.RIBS; level++) {
                doubts.skipped(level).ifPresent(notes::add);
                doubts.halves(level).ifPresent(notes::add);
            }
            SideSlip.find(doubts.height, doubts.vertebrae).ifPresent(notes::add);
        }
        for (int level = FIRST; level <= LAST; level++) {
            doubts.tall(level).ifPresent(notes::add);
        }
        return notes;
    }

    private static String name(int level) {
        return SpineNames.at(SpineNames.place(level));
    }

    private Optional<String> skipped(int level) {
        return height.isSkipped(level) && endBetween(level)
                ? oneOff(level - 1, level)
                        .map(ribs -> name(level) + " is missing between two vertebrae that follow each other, and "
                                + ribs + ": check whether the numbers of the vertebrae skip one")
                : Optional.empty();
    }

    private Optional<String> halves(int level) {
        return height.areHalves(level) && vertebrae.mostAt(level, level + 1) == 1
                ? oneOff(level - 1, level + 2)
                        .map(ribs ->
                                name(level) + " and " + name(level + 1) + " together are as tall as one vertebra, and "
                                        + ribs + ": check whether the two labels hold one vertebra")
                : Optional.empty();
    }

    private Optional<String> tall(int level) {
        double tallness = height.tallness(level);
        return tallness > TALL
                ? Optional.of(String.format(
                        Locale.ROOT,
                        "%s is %.1f times as tall as its neighbours: check whether its label holds two vertebrae",
                        name(level),
                        tallness))
                : Optional.empty();
    }

    /** Whether the ribs above and below that of a vertebra end far enough apart for one between them. */
    private boolean endBetween(int level) {
        double[] apart = Stream.of(Side.RIGHT, Side.LEFT)
                .flatMapToDouble(side -> {
                    OptionalDouble above = vertebrae.end(level - 1, side);
                    OptionalDouble below = vertebrae.end(level + 1, side);
                    return above.isPresent() && below.isPresent()
                            ? DoubleStream.of(above.getAsDouble() - below.getAsDouble())
                            : DoubleStream.empty();
                })
                .toArray();
        double least = TWO_APART * height.spacing(level - 1);
        return apart.length > 0 && Arrays.stream(apart).allMatch(distance -> distance > least);
    }

    /**
     * What tells that vertebrae on one side of a fault have numbers one too far from it, while those on the other side
     * are right; empty if nothing does.
     *
     * @param above number of the last rib above the fault
     * @param below number of the first one below it
     */
    private Optional<String> oneOff(int above, int below) {
        boolean upper = fit(FIRST, above, -1) && fit(below, RibNumbering.RIBS, 0);
        boolean lower = fit(FIRST, above, 0) && fit(below, RibNumbering.RIBS, 1);
        return upper == lower
                ? Optional.empty()
                : Optional.of(
                        upper
                                ? "the ribs above lie beside vertebrae one number lower than theirs"
                                : "the ribs below lie beside vertebrae one number higher than theirs");
    }

    /** Whether ribs of these numbers are known and end so many vertebrae off, one off by their heights as well. */
    private boolean fit(int from, int to, int off) {
        OptionalInt slip = ribs.slip(height, from, to);
        return slip.isPresent()
                && (off == 0 || slip.getAsInt() == off)
                && vertebrae.meet(List.of(Side.RIGHT, Side.LEFT), from, to, off);
    }
}
