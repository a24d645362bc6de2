package org.phrenic.study.validation;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.phrenic.breathing.pattern.BreathingPreset;
import org.phrenic.document.KeySuggestion;
import org.phrenic.document.ShippedFile;
import org.phrenic.document.YamlDocument;
import org.phrenic.document.YamlMap;
import org.phrenic.file.BadInputException;
import org.phrenic.simulation.observe.Observation;
import org.phrenic.study.measure.SceneObservables;

/**
 * Published ranges of human breathing with their sources: a YAML file with a list {@code rows}, each a
 * {@link ReferenceRange}.
 *
 * @param name of the file
 * @param ranges in the order of the file
 */
public record PhysiologyTable(String name, List<ReferenceRange> ranges) {
    /** Keys that say what is measured. */
    private static final List<String> MEASURES =
            List.of("observable", "observables", "reduction", "against", "against_preset", "share");

    private static final String NONE = "none";
    private static final List<String> SEXES = List.of("male", "female");
    private static final List<String> KEYS = List.of(("key preset body observable observables reduction against"
                    + " against_preset share factor low high unit confidence source note missed_because")
            .split(" "));

    public PhysiologyTable {
        ranges = List.copyOf(ranges);
    }

    /** The table distributed with the program. */
    public static PhysiologyTable shipped() {
        return of("physiology.yaml", ShippedFile.yaml("validation/physiology.yaml"));
    }

    /**
     * Reads a table.
     *
     * @throws BadInputException with one sentence that names file, line and key
     */
    public static PhysiologyTable read(Path file) {
        return of(file.getFileName().toString(), YamlDocument.read(file));
    }

    private static PhysiologyTable of(String name, YamlMap yaml) {
        yaml.requireOnly(List.of("rows"));
        List<ReferenceRange> rows = new ArrayList<>();
        Set<String> keys = new HashSet<>();
        for (YamlMap map : yaml.maps("rows")) {
            ReferenceRange row = row(map);
            if (!keys.add(row.key())) {
                throw map.bad("key", "found '" + row.key() + "' a second time, expected each key once");
            }
            rows.add(row);
        }
        if (rows.isEmpty()) {
            throw yaml.bad("rows", "found no row, expected at least one");
        }
        return new PhysiologyTable(name, rows);
    }

    private static ReferenceRange row(YamlMap map) {
        map.requireOnly(KEYS);
        String key = map.text("key");
        if (!key.matches("[a-z0-9_]+")) {
            throw map.bad("key", "found '" + key + "', expected small letters, digits and underscores");
        }
        Optional<String> preset =
                Optional.of(oneOf(map, "preset", BreathingPreset.names(), NONE)).filter(p -> !p.equals(NONE));
        double low = map.number("low", Double.NaN);
        double high = map.number("high", Double.NaN);
        boolean bounded = !Double.isNaN(low) || !Double.isNaN(high);
        require(bounded, map, "low", "found neither low nor high, expected at least one of them");
        String order = "found " + low + " above high " + high + ", expected low to be at most high";
        require(!(low > high), map, "low", order);
        boolean measured = preset.isPresent();
        String note = map.text("note", "");
        String unmeasured = "found none, expected why the quantity cannot be measured here (preset: none)";
        require(measured || !note.isBlank(), map, "note", unmeasured);
        String missReason = map.text("missed_because", "");
        boolean reasoned = map.has("missed_because");
        String nothing = "found nothing, expected why the range is missed";
        require(!reasoned || !missReason.isBlank(), map, "missed_because", nothing);
        String unmissed = "found it with preset none, expected none there: what is not measured is not missed";
        require(!reasoned || measured, map, "missed_because", unmissed);
        for (String measure : MEASURES) {
            require(measured || !map.has(measure), map, measure, "found it with preset none, expected none there");
        }
        Reduction reduction = measured
                ? Reduction.of(oneOf(map, "reduction", Reduction.labels(), null))
                        .orElseThrow()
                : Reduction.START;
        return new ReferenceRange(
                key,
                preset,
                map.has("body") ? Optional.of(oneOf(map, "body", SEXES, null)) : Optional.empty(),
                measured ? observables(map, reduction) : List.of(),
                reduction,
                measured ? against(map, reduction) : "",
                againstPreset(map, reduction),
                share(map, reduction),
                map.number("factor", 1),
                low,
                high,
                map.text("unit"),
                Confidence.of(oneOf(map, "confidence", tags(), null)).orElseThrow(),
                source(map),
                note,
                missReason);
    }

    private static void require(boolean holds, YamlMap map, String key, String problem) {
        if (!holds) {
            throw map.bad(key, problem);
        }
    }

    private static void requireRead(YamlMap map, String key, boolean isRead, Reduction reduction) {
        require(
                isRead || !map.has(key),
                map,
                key,
                "found it with reduction " + reduction.label() + ", expected none there");
    }

    private static String source(YamlMap map) {
        String source = map.text("source");
        require(!source.isBlank(), map, "source", "found nothing, expected where the range comes from");
        return source;
    }

    private static double share(YamlMap map, Reduction reduction) {
        double share = map.number("share", 1);
        require(share > 0 && share <= 1, map, "share", "found " + share + ", expected more than 0 to 1");
        requireRead(map, "share", reduction == Reduction.AT_SHARE, reduction);
        return share;
    }

    private static List<String> observables(YamlMap map, Reduction reduction) {
        boolean many = reduction == Reduction.ORDER;
        List<String> names = many ? map.texts("observables") : List.of(map.text("observable"));
        requireRead(map, many ? "observable" : "observables", false, reduction);
        String tooFew = "found " + names.size() + ", expected at least two to put in order";
        require(!many || names.size() >= 2, map, "observables", tooFew);
        names.forEach(name -> requireObservable(map, many ? "observables" : "observable", name));
        return names;
    }

    private static String against(YamlMap map, Reduction reduction) {
        requireRead(map, "against", reduction.needsSecondObservable(), reduction);
        if (!reduction.needsSecondObservable()) {
            return "";
        }
        requireObservable(map, "against", map.text("against"));
        return map.text("against");
    }

    private static Optional<String> againstPreset(YamlMap map, Reduction reduction) {
        if (!map.has("against_preset")) {
            return Optional.empty();
        }
        String unread = "found it with reduction " + reduction.label() + ", expected none but with ratio and at_share";
        require(reduction.readsSecondPreset(), map, "against_preset", unread);
        return Optional.of(oneOf(map, "against_preset", BreathingPreset.names(), null));
    }

    private static void requireObservable(YamlMap map, String key, String name) {
        if (!Observation.COLUMNS.contains(name) && !SceneObservables.names().contains(name)) {
            List<String> known = new ArrayList<>(Observation.COLUMNS);
            known.addAll(SceneObservables.names());
            throw map.bad(
                    key,
                    "found an unknown observable '" + name + "', "
                            + KeySuggestion.nearest(name, known)
                                    .map(near -> "did you mean '" + near + "'?")
                                    .orElse("expected a column of observables.csv or of docs/validation.md"));
        }
    }

    private static String oneOf(YamlMap map, String key, List<String> known, String also) {
        String found = map.text(key);
        if (known.contains(found) || found.equals(also)) {
            return found;
        }
        throw map.bad(
                key, "found '" + found + "', expected " + String.join(", ", known) + (also == null ? "" : ", " + also));
    }

    private static List<String> tags() {
        return Arrays.stream(Confidence.values()).map(Confidence::tag).toList();
    }
}
