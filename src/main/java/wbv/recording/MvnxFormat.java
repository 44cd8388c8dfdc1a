package wbv.recording;

import java.io.IOException;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;

/** MVNX, the XML that Xsens MVN exports: many segments of one body, read as a stream; external entities are not followed. */
final class MvnxFormat implements Format {

    @Override
    public boolean recognises(Head head) {
        return head.first().startsWith("<");
    }

    @Override
    public RowReader open(Source source, Context context) throws IOException {
        XMLInputFactory factory = XMLInputFactory.newDefaultFactory();
        factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
        factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
        try {
            XMLStreamReader xml = factory.createXMLStreamReader(source.content());
            return new MvnxReader(source, xml, context);
        } catch (XMLStreamException wrong) {
            throw fault(source, wrong);
        }
    }

    static DataFault fault(Source source, XMLStreamException wrong) {
        long line = wrong.getLocation() == null ? 0 : wrong.getLocation().getLineNumber();
        String message = wrong.getMessage().lines().reduce((one, two) -> two).orElse("").replaceFirst("^Message: ", "");
        return DataFault.at(source.name(), Math.max(line, 1), "is not sound XML: " + message, wrong);
    }
}
