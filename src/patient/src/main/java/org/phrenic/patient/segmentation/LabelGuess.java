package org.phrenic.patient.segmentation;

import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.io.volume.LabelVolume;

/**
 * A label table guessed from a volume: by the names of labels in the file, else by the numbers of TotalSegmentator if
 * the labels lie where its structures lie.
 *
 * @param source what the table is made from
 * @param table the table; empty if there is no guess
 * @param confidence from 0 to 1: share of the named labels whose names are known, or share of the comparisons of places
 *     that hold
 * @param reason one sentence without a full stop
 */
public record LabelGuess(Source source, Optional<LabelTable> table, double confidence, String reason) {
    /** What a table is made from. */
    public enum Source {
        /** Names of labels in the file. */
        NAMES,
        /** Numbers of TotalSegmentator. */
        TOTALSEGMENTATOR,
        NONE
    }

    /** Least share of the comparisons of places for the numbers of TotalSegmentator. */
    private static final double LEAST_SHARE = 0.85;

    private static final int MAX_LISTED = 8;

    /** Guesses the table of a volume. */
    public static LabelGuess of(LabelVolume volume) {
        Map<Integer, String> present = new TreeMap<>(volume.names());
        int[] counts = volume.grid().counts();
        present.keySet().removeIf(label -> label >= counts.length || counts[label] == 0);
        Map<Integer, String> known = new TreeMap<>();
        present.forEach((label, name) -> LabelNames.structure(name).ifPresent(s -> known.put(label, s)));
        if (!known.isEmpty()) {
            return new LabelGuess(
                    Source.NAMES,
                    Optional.of(new LabelTable(known).withRest(volume)),
                    (double) known.size() / present.size(),
                    "labels are taken by their names in the file, of which " + known.size() + " of " + present.size()
                            + " are known");
        }
        ToolNumbers numbers = ToolNumbers.of(volume.grid());
        LabelPlaces places = numbers.places();
        if (places.compared() >= LabelPlaces.ENOUGH && places.share() >= LEAST_SHARE) {
            return ofNumbers(volume, numbers, places.share(), "");
        }
        Optional<BodyAxes> other = StatedAxes.ofNumbers(places);
        if (other.isPresent()) {
            String letters = other.get().letters(volume.grid());
            return ofNumbers(volume, numbers, places.share(other.get()), " if the axes are " + letters);
        }
        return new LabelGuess(Source.NONE, Optional.empty(), places.share(), problem(volume, counts, places));
    }

    private static LabelGuess ofNumbers(LabelVolume volume, ToolNumbers numbers, double share, String condition) {
        return new LabelGuess(
                Source.TOTALSEGMENTATOR,
                Optional.of(new LabelTable(numbers.structures()).withRest(volume)),
                share,
                String.format(
                        Locale.ROOT,
                        "labels are taken for TotalSegmentator's numbers: %.0f %% of %d comparisons of places fit%s",
                        100 * share,
                        numbers.places().compared(),
                        condition));
    }

    private static String problem(LabelVolume volume, int[] counts, LabelPlaces places) {
        String labels = IntStream.range(1, counts.length)
                .filter(label -> counts[label] > 0)
                .limit(MAX_LISTED)
                .mapToObj(String::valueOf)
                .collect(Collectors.joining(", "));
        return "found labels " + labels
                + (volume.names().isEmpty() ? " without names" : " with no name of a structure")
                + (places.compared() < LabelPlaces.ENOUGH
                        ? ""
                        : ", not where TotalSegmentator's structures of these numbers lie");
    }

    /**
     * The table.
     *
     * @param file name of the volume, for the message
     * @throws BadInputException if there is no guess
     */
    public LabelTable require(String file) {
        return table.orElseThrow(() -> new BadInputException(
                file + ": " + reason + ", expected --labels with a table of label and structure, such as 1,lungs, or"
                        + " --labels " + LabelTable.TOTALSEGMENTATOR));
    }
}
