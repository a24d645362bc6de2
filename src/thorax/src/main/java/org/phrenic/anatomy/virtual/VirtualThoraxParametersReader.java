package org.phrenic.anatomy.virtual;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import org.phrenic.document.YamlDocument;
import org.phrenic.document.YamlMap;
import org.phrenic.file.BadInputException;

/** Reads {@link VirtualThoraxParameters} from YAML. Unknown keys, missing keys and wrong counts are errors. */
public final class VirtualThoraxParametersReader {
    private static final String FOLDER = "/org/phrenic/data/thorax/";

    private VirtualThoraxParametersReader() {}

    /**
     * The measures that come with the program.
     *
     * @param preset {@code adult-male} or {@code adult-female}
     * @throws IllegalArgumentException if there is no such body
     */
    public static VirtualThoraxParameters preset(String preset) {
        String file = preset + ".yaml";
        try (InputStream in = VirtualThoraxParametersReader.class.getResourceAsStream(FOLDER + file)) {
            if (in == null) {
                throw new IllegalArgumentException(
                        "virtual thorax '" + preset + "' is not known, expected adult-male or adult-female");
            }
            return measures(YamlDocument.read(file, in));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * Measures from a YAML text.
     *
     * @param source what to call the text in messages
     * @throws BadInputException with one sentence naming source, line and key if the text is no full set of measures
     */
    public static VirtualThoraxParameters read(String source, String text) {
        return measures(YamlDocument.parse(source, text));
    }

    private static VirtualThoraxParameters measures(YamlMap yaml) {
        return yaml.bind(VirtualThoraxParameters.class);
    }
}
