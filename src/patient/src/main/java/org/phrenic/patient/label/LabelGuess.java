package org.phrenic.patient.label;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.io.volume.LabelVolume;

/**
 * A label table guessed from a volume: by the names of labels in the file, if there are none by the numbers of a tool
 * or a public data set ({@link NumberTable}) whose structures lie where the labels do and are as large, one over
 * another.
 *
 * @param source what the table is made from
 * @param table the table; empty if there is no guess
 * @param confidence from 0 to 1: share of the named labels whose names are known, or share of the comparisons of places
 *     and volumes that hold
 * @param reason one sentence without a full stop
 */
public record LabelGuess(Source source, Optional<LabelTable> table, double confidence, String reason) {
    /** What a table is made from. */
    public enum Source {
        /** Names of labels in the file. */
        NAMES,
        /** Numbers of a tool or a public data set. */
        NUMBERS,
        NONE,
        /** Labels with which no table helps: the volume itself has to be another one. */
        REFUSED
    }

    private static final int MAX_LISTED = 8;

    /** Guesses the table of a volume. */
    public static LabelGuess of(LabelVolume volume) {
        Optional<String> interpolated = volume.isImage() ? Optional.empty() : InterpolatedLabels.problem(volume.grid());
        if (interpolated.isPresent()) {
            return new LabelGuess(Source.REFUSED, Optional.empty(), 0, interpolated.get());
        }
        int[] counts = volume.grid().counts();
        NamedLabels named = NamedLabels.of(volume);
        Map<Integer, String> present = named.names();
        Map<Integer, String> known = named.structures();
        if (named.areKnown()) {
            return new LabelGuess(
                    Source.NAMES,
                    Optional.of(new LabelTable(known).withRest(volume)),
                    (double) known.size() / present.size(),
                    "labels are taken by their names, of which " + known.size() + " of " + present.size()
                            + " are known");
        }
        List<String> unknown = present.values().stream()
                .filter(name -> !LabelVolume.isNumber(name))
                .toList();
        if (!unknown.isEmpty()) {
            return none("found labels with no name of a structure: "
                    + unknown.stream().limit(MAX_LISTED).map(Numbers::quote).collect(Collectors.joining(", ")));
        }
        if (volume.isImage()) {
            return none("found grey values, as of an image that has to be segmented first");
        }
        return byNumbers(volume, counts);
    }

    private static LabelGuess none(String reason) {
        return new LabelGuess(Source.NONE, Optional.empty(), 0, reason);
    }

    private static LabelGuess byNumbers(LabelVolume volume, int[] counts) {
        LabelPositions positions = NumberMatch.positions(volume.grid());
        NumberMatch numbers = NumberMatch.best(positions, NumberTable.ALL);
        if (numbers.fits()) {
            return ofNumbers(volume, numbers, BodyAxes.STATED, "");
        }
        Optional<NumberMatch> turned =
                numbers.isPossible() ? Optional.empty() : NumberMatch.inOtherAxes(positions, NumberTable.ALL);
        Optional<String> letters = turned.flatMap(NumberMatch::otherAxes).map(axes -> axes.letters(volume.grid()));
        if (turned.isPresent() && !turned.get().mayBeInAnotherOrder()) {
            return ofNumbers(
                    volume,
                    turned.get(),
                    turned.get().otherAxes().orElseThrow(),
                    " if the axes are " + letters.orElseThrow());
        }
        Optional<NumberMatch> exchanged =
                numbers.isPossible() ? Optional.empty() : NumberMatch.withSidesExchanged(positions, NumberTable.ALL);
        String fit = turned.map(match -> "fit numbers of " + match.table().title() + " if the axes are "
                        + letters.orElseThrow() + ", but may count bones in another order as well")
                .or(() -> exchanged.map(match -> "fit numbers of "
                        + match.table().title() + " but for right and left structures, which are exchanged"))
                .orElseGet(() -> fit(numbers));
        return new LabelGuess(
                Source.NONE, Optional.empty(), numbers.share(BodyAxes.STATED), problem(volume, counts, fit));
    }

    private static String fit(NumberMatch numbers) {
        if (!numbers.isPossible()) {
            return "fit numbers of no known tool or data set";
        }
        return numbers.tellsTooLittle()
                ? "are too few to tell whose numbers they are"
                : "fit numbers of " + numbers.table().title() + ", but anybody may number a few structures so";
    }

    private static LabelGuess ofNumbers(LabelVolume volume, NumberMatch numbers, BodyAxes axes, String condition) {
        double share = numbers.share(axes);
        return new LabelGuess(
                Source.NUMBERS,
                Optional.of(new LabelTable(numbers.structures()).withRest(volume)),
                share,
                Numbers.format(
                        "labels are taken for numbers of %s: %.0f %% of %d comparisons of places and volumes fit%s",
                        numbers.table().title(), 100 * share, numbers.compared(), condition));
    }

    private static String problem(LabelVolume volume, int[] counts, String fit) {
        String labels = IntStream.range(1, counts.length)
                .filter(label -> counts[label] > 0)
                .limit(MAX_LISTED)
                .mapToObj(String::valueOf)
                .collect(Collectors.joining(", "));
        if (labels.isEmpty()) {
            return "found background alone";
        }
        return "found labels " + labels
                + (volume.names().isEmpty() ? " without names" : " with no name of a structure")
                + ", which " + fit;
    }

    /** Whether no table helps: the volume itself has to be another one. */
    public boolean isRefused() {
        return source == Source.REFUSED;
    }

    /**
     * The table.
     *
     * @param file name of the volume, for the message
     * @throws BadInputException if there is no guess
     */
    public LabelTable require(String file) {
        String expected = isRefused()
                ? ""
                : ", expected --labels with a table of label and structure, such as 1,lungs, or with one of "
                        + String.join(", ", NumberTable.distinctNames());
        return table.orElseThrow(() -> new BadInputException(file + ": " + reason + expected));
    }
}
