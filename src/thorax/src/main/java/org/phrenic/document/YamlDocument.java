package org.phrenic.document;

import com.fasterxml.jackson.core.JacksonException;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.io.IOContext;
import com.fasterxml.jackson.dataformat.yaml.YAMLFactory;
import com.fasterxml.jackson.dataformat.yaml.YAMLParser;
import java.io.IOException;
import java.io.Reader;
import java.io.StringReader;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.phrenic.document.YamlValue.Place;
import org.phrenic.file.BadInputException;
import org.yaml.snakeyaml.DumperOptions;
import org.yaml.snakeyaml.LoaderOptions;
import org.yaml.snakeyaml.error.MarkedYAMLException;
import org.yaml.snakeyaml.events.AliasEvent;
import org.yaml.snakeyaml.events.CollectionStartEvent;
import org.yaml.snakeyaml.events.DocumentStartEvent;
import org.yaml.snakeyaml.events.Event;
import org.yaml.snakeyaml.events.ImplicitTuple;
import org.yaml.snakeyaml.events.NodeEvent;
import org.yaml.snakeyaml.events.ScalarEvent;
import org.yaml.snakeyaml.nodes.Tag;

/**
 * Reads a single YAML document whose root is a mapping, with Jackson's streaming parser. Values are maps, lists and
 * texts. Duplicate keys are rejected. Depth, number of values and aliases are limited, so that a small file cannot
 * expand to a large document.
 */
public final class YamlDocument {
    private static final int MAX_DEPTH = 30;
    private static final int MAX_ALIASES = 20;
    private static final int MAX_VALUES = 1_000_000;
    /** Room for as many values with their indentation, and paths among them; the parser refuses 3 MB by itself. */
    private static final int MAX_CODE_POINTS = 1 << 28;

    private static final YAMLFactory FACTORY = new EventFactory();

    private final String file;
    private final EventParser parser;
    private int valueCount;
    private int aliasCount;

    private YamlDocument(String file, EventParser parser) {
        this.file = file;
        this.parser = parser;
    }

    /**
     * Reads {@code file}.
     *
     * @throws BadInputException if it cannot be read, is not UTF-8 or not a YAML mapping, or has duplicate keys
     */
    public static YamlMap read(Path file) {
        return parse(file.toString(), TextFile.read(file, "a text file"));
    }

    /**
     * Parses {@code text}; an empty text is an empty mapping.
     *
     * @param name name for error messages
     */
    public static YamlMap parse(String name, String text) {
        try (EventParser parser = (EventParser) FACTORY.createParser(new StringReader(text))) {
            return new YamlDocument(name, parser).document();
        } catch (IOException | IllegalArgumentException broken) {
            throw unreadable(name, broken);
        }
    }

    private static BadInputException unreadable(String name, Exception broken) {
        String line = "";
        String problem =
                broken instanceof JacksonException jackson ? jackson.getOriginalMessage() : broken.getMessage();
        if (broken.getCause() instanceof MarkedYAMLException marked && marked.getProblemMark() != null) {
            line = "line " + (marked.getProblemMark().getLine() + 1) + ": ";
            problem = marked.getProblem();
        }
        return new BadInputException(
                name + ": " + line + "found YAML that cannot be read ("
                        + String.valueOf(problem).replaceAll("\\p{Cntrl}", "?") + "), expected 'key: value' lines",
                broken);
    }

    private YamlMap document() throws IOException {
        Place top = new Place(file, 1, "");
        if (parser.nextToken() == null) {
            return new YamlMap(top, new LinkedHashMap<>());
        }
        YamlValue root = value(top, 0);
        if (parser.nextToken() != null) {
            throw new Place(file, parser.documentLine, "").bad("found another document, expected one");
        }
        return root.map();
    }

    /** Parses the value that begins at the current token. */
    private YamlValue value(Place place, int depth) throws IOException {
        count(place, depth);
        if (parser.event() instanceof AliasEvent alias) {
            return copy(aliased(alias, place), place);
        }
        String anchor = ((NodeEvent) parser.event()).getAnchor();
        if (anchor != null) {
            parser.anchors.put(anchor, null);
        }
        YamlValue value = content(place, depth);
        if (anchor != null) {
            parser.anchors.put(anchor, value);
        }
        return value;
    }

    private YamlValue content(Place place, int depth) throws IOException {
        if (parser.event() instanceof ScalarEvent scalar) {
            requireStandardTag(scalar.getTag(), place);
            boolean nothing = parser.currentToken() == JsonToken.VALUE_NULL;
            return new YamlValue(place, nothing ? null : scalar.getValue(), !scalar.isPlain());
        }
        requireStandardTag(((CollectionStartEvent) parser.event()).getTag(), place);
        if (parser.currentToken() == JsonToken.START_OBJECT) {
            return new YamlValue(place, mapping(place, depth), false);
        }
        List<YamlValue> items = new ArrayList<>();
        while (parser.nextToken() != JsonToken.END_ARRAY) {
            items.add(value(place.item(items.size(), parser.line()), depth + 1));
        }
        return new YamlValue(place, items, false);
    }

    private YamlMap mapping(Place place, int depth) throws IOException {
        Map<String, YamlValue> values = new LinkedHashMap<>();
        while (nextKey(place) != JsonToken.END_OBJECT) {
            String key = parser.currentName();
            Place at = place.key(key, parser.line());
            String anchor = ((NodeEvent) parser.event()).getAnchor();
            if (anchor != null) {
                parser.anchors.put(anchor, new YamlValue(at, key, false));
            }
            parser.nextToken();
            if (values.put(key, value(at, depth + 1)) != null) {
                throw at.bad("found the key a second time, expected it once");
            }
        }
        return new YamlMap(place, values);
    }

    private JsonToken nextKey(Place place) throws IOException {
        try {
            return parser.nextToken();
        } catch (JacksonException broken) {
            if (broken.getCause() == null && parser.event() instanceof CollectionStartEvent) {
                throw new Place(file, parser.line(), place.path())
                        .bad("found a list or mapping as a key, expected a word");
            }
            throw broken;
        }
    }

    private YamlValue aliased(AliasEvent alias, Place place) {
        YamlValue value = parser.anchors.get(alias.getAnchor());
        if (value == null) {
            throw parser.anchors.containsKey(alias.getAnchor())
                    ? tooMany(place)
                    : place.bad("found the undefined alias '" + alias.getAnchor() + "', expected an anchor before it");
        }
        if (!(value.content() instanceof String) && ++aliasCount > MAX_ALIASES) {
            throw place.bad("found more than " + MAX_ALIASES + " aliases of lists or mappings, expected fewer");
        }
        return value;
    }

    /** The same value with another location; nested values keep the location of the anchor. */
    private static YamlValue copy(YamlValue value, Place place) {
        Object content = value.content() instanceof YamlMap map ? new YamlMap(place, map.values()) : value.content();
        return new YamlValue(place, content, value.quoted());
    }

    private void count(Place place, int depth) {
        if (depth > MAX_DEPTH || ++valueCount > MAX_VALUES) {
            throw tooMany(place);
        }
    }

    private static BadInputException tooMany(Place place) {
        return place.bad("found values nested within themselves or without end, expected at most " + MAX_DEPTH
                + " levels and " + MAX_VALUES + " values");
    }

    private static void requireStandardTag(String tag, Place place) {
        if (tag != null && !tag.equals("!") && new Tag(tag.strip()).isCustomGlobal()) {
            throw place.bad("found '" + tag + "': this tag is not allowed, expected a plain value");
        }
    }

    /** Jackson's parser with access to the event of the current token, which has the quotes, anchors and tags. */
    private static final class EventParser extends YAMLParser {
        /** Values by anchor; null while the value of the anchor is being read. */
        private final Map<String, YamlValue> anchors = new HashMap<>();
        /** First line of the current document. */
        private int documentLine;

        EventParser(IOContext context, int features, int yamlFeatures, LoaderOptions options, Reader reader) {
            super(context, features, yamlFeatures, options, null, reader);
        }

        @Override
        protected Event getEvent() throws IOException {
            Event event = super.getEvent();
            if (event instanceof DocumentStartEvent) {
                documentLine = event.getStartMark().getLine() + 1;
            }
            // Jackson does not accept an alias as a key.
            boolean key = getParsingContext().inObject() && currentToken() != JsonToken.FIELD_NAME;
            YamlValue known = key && event instanceof AliasEvent alias ? anchors.get(alias.getAnchor()) : null;
            if (known != null && known.content() instanceof String text) {
                return new ScalarEvent(
                        null,
                        null,
                        new ImplicitTuple(true, false),
                        text,
                        event.getStartMark(),
                        event.getEndMark(),
                        DumperOptions.ScalarStyle.PLAIN);
            }
            return event;
        }

        Event event() {
            return _lastEvent;
        }

        int line() {
            return _lastEvent.getStartMark().getLine() + 1;
        }
    }

    private static final class EventFactory extends YAMLFactory {
        @Override
        protected YAMLParser _createParser(Reader reader, IOContext context) {
            LoaderOptions options = new LoaderOptions();
            options.setCodePointLimit(MAX_CODE_POINTS);
            return new EventParser(context, _parserFeatures, _yamlParserFeatures, options, reader);
        }
    }
}
