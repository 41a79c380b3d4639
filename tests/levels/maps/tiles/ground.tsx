<?xml version="1.0" encoding="UTF-8"?>
<tileset name="ground" tilewidth="32" tileheight="32" tilecount="8" columns="8"><tile id="0"><objectgroup draworder="index">
<object id="1" x="0" y="0" width="32" height="32"/>
</objectgroup>
</tile>
<tile id="1"><objectgroup draworder="index">
<object id="1" x="4" y="6" width="20" height="20"><ellipse/>
</object>
</objectgroup>
</tile>
<tile id="2"><objectgroup draworder="index">
<object id="1" x="0" y="32"><polygon points="0,0 32,-32 32,0"/>
</object>
</objectgroup>
</tile>
<tile id="3"><objectgroup draworder="index">
<object id="1" x="0" y="0" width="32" height="10"/>
<object id="2" x="6" y="18" width="9" height="14"/>
</objectgroup>
</tile>
<tile id="4"><objectgroup draworder="index">
<object id="1" x="0" y="0"><polygon points="0,0 12,0 12,20 32,20 32,32 0,32"/>
</object>
</objectgroup>
</tile>
<tile id="5"><objectgroup draworder="index">
<object id="1" x="9" y="3" width="18" height="6" rotation="37"/>
</objectgroup>
</tile>
<tile id="7"><properties>
<property name="friction" type="float" value="0.02"/>
<property name="solid" type="bool" value="true"/>
</properties>
</tile>
</tileset>
