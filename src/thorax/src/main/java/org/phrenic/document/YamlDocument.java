package org.phrenic.document;

import java.io.IOException;
import java.io.InputStream;
import java.io.StringReader;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.phrenic.file.BadInputException;
import org.phrenic.file.InputBytes;
import org.yaml.snakeyaml.LoaderOptions;
import org.yaml.snakeyaml.composer.Composer;
import org.yaml.snakeyaml.error.MarkedYAMLException;
import org.yaml.snakeyaml.error.YAMLException;
import org.yaml.snakeyaml.nodes.MappingNode;
import org.yaml.snakeyaml.nodes.Node;
import org.yaml.snakeyaml.nodes.NodeTuple;
import org.yaml.snakeyaml.nodes.ScalarNode;
import org.yaml.snakeyaml.nodes.SequenceNode;
import org.yaml.snakeyaml.nodes.Tag;
import org.yaml.snakeyaml.parser.ParserImpl;
import org.yaml.snakeyaml.reader.StreamReader;
import org.yaml.snakeyaml.resolver.Resolver;

/**
 * Reads one YAML document whose top is a mapping. Nothing is constructed but maps, lists and texts; keys may not come
 * twice; nesting and repeated aliases are limited, so a small file cannot unfold into a large one.
 */
public final class YamlDocument {
    private static final int MAX_DEPTH = 30;
    private static final int MAX_ALIASES = 20;
    private static final int MAX_VALUES = 1_000_000;

    private final String file;
    private int valueCount;

    private YamlDocument(String file) {
        this.file = file;
    }

    /**
     * Reads {@code file}.
     *
     * @throws BadInputException if it cannot be read, is not UTF-8 or no YAML mapping, or repeats a key
     */
    public static YamlMap read(Path file) {
        return parse(file.toString(), text(file.toString(), InputBytes.read(file)));
    }

    /**
     * Reads a stream, which stays open.
     *
     * @param name what to call it in messages
     */
    public static YamlMap read(String name, InputStream stream) {
        try {
            return parse(name, text(name, stream.readAllBytes()));
        } catch (IOException failure) {
            throw new BadInputException(name + ": reading failed: " + failure.getMessage(), failure);
        }
    }

    /**
     * Reads {@code text}; an empty text is an empty mapping.
     *
     * @param name what to call it in messages
     */
    public static YamlMap parse(String name, String text) {
        LoaderOptions options = new LoaderOptions();
        options.setAllowDuplicateKeys(false);
        options.setAllowRecursiveKeys(false);
        options.setMaxAliasesForCollections(MAX_ALIASES);
        options.setNestingDepthLimit(MAX_DEPTH);
        // The composer alone: what builds and writes objects would be loaded for nothing.
        Composer composer = new Composer(
                new ParserImpl(new StreamReader(new StringReader(text)), options), new Resolver(), options);
        try {
            Node root = composer.getSingleNode();
            YamlValue.Place top = new YamlValue.Place(name, 1, "");
            return root == null
                    ? new YamlMap(top, new LinkedHashMap<>())
                    : new YamlDocument(name).value(root, top, 0).map();
        } catch (MarkedYAMLException broken) {
            String line = broken.getProblemMark() == null
                    ? ""
                    : "line " + (broken.getProblemMark().getLine() + 1) + ": ";
            throw new BadInputException(
                    name + ": " + line + "found YAML that cannot be read (" + broken.getProblem()
                            + "), expected 'key: value' lines",
                    broken);
        } catch (YAMLException broken) {
            throw new BadInputException(
                    name + ": found YAML that cannot be read (" + oneLine(broken.getMessage())
                            + "), expected 'key: value' lines",
                    broken);
        }
    }

    private YamlValue value(Node node, YamlValue.Place place, int depth) {
        if (depth > MAX_DEPTH || ++valueCount > MAX_VALUES) {
            throw place.bad("found values nested within themselves or without end, expected at most " + MAX_DEPTH
                    + " levels and " + MAX_VALUES + " values");
        }
        if (node instanceof MappingNode mapping) {
            return new YamlValue(place, map(mapping, place, depth), false);
        }
        if (node instanceof SequenceNode sequence) {
            List<YamlValue> items = new ArrayList<>();
            for (Node item : sequence.getValue()) {
                items.add(value(item, place.item(items.size(), line(item)), depth + 1));
            }
            return new YamlValue(place, items, false);
        }
        ScalarNode scalar = (ScalarNode) node;
        boolean plain = scalar.isPlain();
        boolean nothing = plain && Tag.NULL.equals(scalar.getTag());
        return new YamlValue(place, nothing ? null : scalar.getValue(), !plain);
    }

    private YamlMap map(MappingNode mapping, YamlValue.Place place, int depth) {
        Map<String, YamlValue> values = new LinkedHashMap<>();
        for (NodeTuple entry : mapping.getValue()) {
            Node keyNode = entry.getKeyNode();
            if (!(keyNode instanceof ScalarNode scalar)) {
                throw new YamlValue.Place(file, line(keyNode), place.path())
                        .bad("found a list or mapping as a key, expected a word");
            }
            String key = scalar.getValue();
            YamlValue.Place at = place.key(key, line(keyNode));
            if (values.put(key, value(entry.getValueNode(), at, depth + 1)) != null) {
                throw at.bad("found the key a second time, expected it once");
            }
        }
        return new YamlMap(place, values);
    }

    private static int line(Node node) {
        return node.getStartMark() == null ? 0 : node.getStartMark().getLine() + 1;
    }

    private static String text(String name, byte[] bytes) {
        try {
            String text = StandardCharsets.UTF_8
                    .newDecoder()
                    .decode(ByteBuffer.wrap(bytes))
                    .toString();
            return text.startsWith("\uFEFF") ? text.substring(1) : text;
        } catch (CharacterCodingException notUtf8) {
            throw new BadInputException(name + ": found bytes that are not UTF-8, expected a text file", notUtf8);
        }
    }

    private static String oneLine(String message) {
        return message == null ? "no reason given" : message.lines().findFirst().orElse("");
    }
}
