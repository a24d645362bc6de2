package org.phrenic.study.regression;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.phrenic.document.YamlMap;
import org.phrenic.file.Numbers;
import org.phrenic.simulation.observe.Observation;

/**
 * Stored results of a scene: positions of sampled nodes and all observables at several times.
 *
 * @param specification {@link RegressionScene#specification} of the scene
 * @param nodeCount number of nodes of the scene
 * @param nodes sampled nodes, in the caller's numbering
 * @param frames one per time
 * @param unknown columns of the observables that the scene does not have; of stored results, those without a number
 */
record RegressionReference(String specification, int nodeCount, int[] nodes, List<Frame> frames, Set<String> unknown) {
    private static final List<String> KEYS = List.of("of", "nodes_in_all", "nodes", "frames");
    private static final List<String> FRAME_KEYS = List.of("time_s", "positions_um", "observables");
    /** Number of sampled nodes: enough to detect a change anywhere in the body, few enough for a small file. */
    private static final int MAX_SAMPLED_NODES = 96;

    private static final double UM_PER_MM = 1000;
    /** Value of an observable that the scene does not have. */
    private static final String UNKNOWN = "unknown";

    /**
     * Results at one time.
     *
     * @param timeS simulated time, s
     * @param positions of the sampled nodes, three coordinates each, mm
     * @param observables in the order of {@link Observation#COLUMNS}; NaN for the unknown ones
     */
    record Frame(double timeS, double[] positions, double[] observables) {}

    /**
     * Nodes evenly spaced over the numbering. Organs are numbered one after the other, so each large organ is sampled.
     */
    static int[] sampledNodes(int nodesInAll) {
        int count = Math.min(MAX_SAMPLED_NODES, nodesInAll);
        int[] kept = new int[count];
        Arrays.setAll(kept, i -> (int) ((i + 0.5) * nodesInAll / count));
        return kept;
    }

    /** Values for YAML; positions in whole micrometres. A NaN of an observable that the scene has stays one. */
    Map<String, Object> values() {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("of", specification);
        map.put("nodes_in_all", nodeCount);
        map.put("nodes", line(Arrays.stream(nodes).asLongStream().toArray()));
        List<Object> list = new ArrayList<>();
        for (Frame frame : frames) {
            Map<String, Object> each = new LinkedHashMap<>();
            each.put("time_s", frame.timeS());
            each.put(
                    "positions_um",
                    line(Arrays.stream(frame.positions())
                            .mapToLong(mm -> Math.round(mm * UM_PER_MM))
                            .toArray()));
            Map<String, Object> seen = new LinkedHashMap<>();
            for (int c = 0; c < Observation.COLUMNS.size(); c++) {
                String column = Observation.COLUMNS.get(c);
                seen.put(column, unknown.contains(column) ? UNKNOWN : rounded(frame.observables()[c]));
            }
            each.put("observables", seen);
            list.add(each);
        }
        map.put("frames", list);
        return map;
    }

    /** Numbers as one line of text, because a YAML list would take one line per number. */
    private static String line(long[] numbers) {
        StringBuilder text = new StringBuilder();
        for (long number : numbers) {
            text.append(text.length() == 0 ? "" : " ").append(number);
        }
        return text.toString();
    }

    /** Rounds to 1e-6. Observables are at most a few hundred, and their tolerance is a thousandth of that. */
    static double rounded(double value) {
        double scaled = Math.rint(value * 1e6) / 1e6;
        return scaled == 0 ? 0 : scaled;
    }

    /**
     * Reads the references of a scene.
     *
     * @throws org.phrenic.file.BadInputException with one sentence, if values are missing or belong to another scene
     */
    static RegressionReference read(YamlMap yaml, RegressionScene scene) {
        yaml.requireOnly(KEYS);
        if (!yaml.text("of").equals(scene.specification())) {
            throw yaml.bad(
                    "of",
                    "found references of another scene (" + yaml.text("of") + "), expected " + scene.specification()
                            + "; --write-references makes them anew");
        }
        int inAll = yaml.wholeInt("nodes_in_all");
        int[] nodes = Arrays.stream(numbers(yaml, "nodes", -1))
                .mapToInt(node -> {
                    if (node < 0 || node >= inAll) {
                        throw yaml.bad("nodes", "found node " + node + ", expected 0 to " + (inAll - 1));
                    }
                    return (int) node;
                })
                .toArray();
        List<Frame> frames = new ArrayList<>();
        Set<String> unknown = new HashSet<>();
        for (YamlMap map : yaml.maps("frames")) {
            map.requireOnly(FRAME_KEYS);
            double[] positions = Arrays.stream(numbers(map, "positions_um", 3 * nodes.length))
                    .mapToDouble(um -> um / UM_PER_MM)
                    .toArray();
            YamlMap seen = map.map("observables");
            seen.keys().stream()
                    .filter(column -> seen.text(column).equals(UNKNOWN))
                    .forEach(unknown::add);
            double[] observables = Observation.COLUMNS.stream()
                    .mapToDouble(column -> unknown.contains(column) ? Double.NaN : seen.number(column))
                    .toArray();
            frames.add(new Frame(map.number("time_s"), positions, observables));
        }
        if (frames.size() != scene.timesS().length) {
            throw yaml.bad("frames", "found " + frames.size() + " times, expected " + scene.timesS().length);
        }
        return new RegressionReference(scene.specification(), inAll, nodes, List.copyOf(frames), unknown);
    }

    private static long[] numbers(YamlMap map, String key, int expected) {
        String[] parts = map.text(key).strip().split("\\s+", -1);
        String problem = "', expected whole numbers with blanks between them";
        long[] numbers = Arrays.stream(parts)
                .mapToLong(part -> Numbers.parseWhole(part, Long.MIN_VALUE, Long.MAX_VALUE)
                        .orElseThrow(() -> map.bad(key, "found '" + part + problem)))
                .toArray();
        if (expected >= 0 && parts.length != expected) {
            throw map.bad(key, "found " + parts.length + " numbers, expected " + expected);
        }
        return numbers;
    }
}
