package org.phrenic.document;

import java.nio.file.Path;
import java.util.Map;
import org.phrenic.file.AtomicFile;
import org.phrenic.file.OutputException;
import org.yaml.snakeyaml.DumperOptions;
import org.yaml.snakeyaml.LoaderOptions;
import org.yaml.snakeyaml.Yaml;
import org.yaml.snakeyaml.constructor.SafeConstructor;
import org.yaml.snakeyaml.representer.Representer;

/** Writes maps as YAML with one key per line, in order. {@link YamlDocument} reads the same values back. */
public final class YamlWriter {
    private static final int WIDTH = 4096;

    private YamlWriter() {}

    /**
     * Formats {@code values} as YAML.
     *
     * @param values maps, lists, double arrays, numbers, booleans, texts, enum constants, nulls
     * @throws IllegalArgumentException for NaN, infinity or a value of another type, naming its key
     */
    public static String format(Map<String, ?> values) {
        DumperOptions options = new DumperOptions();
        options.setDefaultFlowStyle(DumperOptions.FlowStyle.BLOCK);
        options.setSplitLines(false);
        options.setWidth(WIDTH);
        options.setLineBreak(DumperOptions.LineBreak.UNIX);
        Yaml yaml = new Yaml(new SafeConstructor(new LoaderOptions()), new Representer(options), options);
        return yaml.dump(PlainValues.copy("", values));
    }

    /**
     * Writes {@link #format} to {@code file} atomically.
     *
     * @throws OutputException if the file cannot be written
     */
    public static void write(Path file, Map<String, ?> values) {
        AtomicFile.write(file, format(values));
    }
}
