// Writes abi.js and abi.d.ts: constants, and the layout of structs in wasm32, from bindings/dragmesh_api.json.
//   node bindings/js/describe.mjs DESCRIPTION.json OUTPUT_FOLDER     scripts/describe runs it
import { createHash } from 'node:crypto';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

const ABI = '32-bit'; // the description's name for the layout that wasm32 shares
const HEADER = 'dragmesh/dragmesh.h'; // the extensions are not in the module
const NOTE = '// Written by bindings/js/describe.mjs from bindings/dragmesh_api.json: not to be edited.\n';

const [, , source, folder] = process.argv;
const api = JSON.parse(readFileSync(source, 'utf8'));
const ours = list => list.filter(entry => entry.header === HEADER);
const structs = new Map(ours(api.structs).filter(struct => struct.name !== 'dm_core_1').map(struct => [struct.name, struct]));
const typedefs = new Map(api.types.map(type => [type.name, type]));

const camel = name => name.replace(/_([a-z0-9])/g, (_, letter) => letter.toUpperCase());

// How a field is read and written: a kind of number, a struct, or an address (callbacks: an entry of the module's table).
const numberKinds = { float: 'f32', int32_t: 'i32', uint32_t: 'u32', uint64_t: 'u64', size_t: 'u32', uint8_t: 'u8', double: 'f64' };
function kindOf(type) {
    const alias = typedefs.get(type.name);
    if (type.pointers || type.callback || alias?.kind === 'callback' || alias?.kind === 'opaque') return 'u32';
    if (structs.has(type.name)) return type.name;
    const kind = numberKinds[alias?.integer ?? type.name];
    if (!kind) throw new Error(`bindings/js/describe.mjs: the type ${type.c} is new`);
    return kind;
}

function layoutOf(struct) {
    const { size, offsets } = struct.layout[ABI];
    const fields = struct.fields.map((field, i) => {
        const count = field.type.count ?? 1;
        return `        ${camel(field.name)}: [${offsets[i]}, '${kindOf(field.type)}'${count > 1 ? `, ${count}` : ''}],\n`;
    });
    return `    ${struct.name}: { size: ${size}, fields: {\n${fields.join('')}    } },\n`;
}

// The enums of the header have no names: what each is called here, and the prefix that its constants lose, by its first one.
const enumNames = {
    DM_OK: ['Result', 'DM_'], DM_LOG_ERROR: ['LogLevel', 'DM_LOG_'], DM_AXES_GLTF: ['Axes', 'DM_AXES_'],
    DM_PICK_AUTO: ['Picking', 'DM_PICK_'], DM_JOINT_UNKNOWN: ['JointType', 'DM_JOINT_'], DM_FLOAT32: ['FloatFormat', 'DM_'],
    DM_UINT32: ['IntegerFormat', 'DM_'], DM_PER_VERTEX: ['PartIdScope', 'DM_PER_'],
    DM_JOINT_FROM_NETWORK: ['JointSource', 'DM_JOINT_'], DM_LIMIT_LOWER: ['Limit', 'DM_LIMIT_'],
    DM_CHOICE_KEEP: ['Choice', 'DM_CHOICE_'], DM_PREPARE_WITHOUT_PICKING: ['PrepareFlag', 'DM_PREPARE_'],
    DM_DRAG_KEEP_JOINT: ['DragFlag', 'DM_DRAG_'], DM_RULE_LOCKED: ['RuleFlag', 'DM_RULE_'],
    DM_LINK_MOVES: ['LinkKind', 'DM_LINK_'], DM_LINK_BOTH_WAYS: ['LinkFlag', 'DM_LINK_'], DM_HAND_NONE: ['HandKind', 'DM_HAND_'],
    DM_INPUT_LOCKED: ['InputFlag', 'DM_INPUT_'], DM_DRAG_HELD: ['DragPhase', 'DM_DRAG_'],
    DM_EVENT_LIMIT_LOWER: ['DragEvent', 'DM_EVENT_'], DM_GO_AUTO: ['Go', 'DM_GO_'],
    DM_INTENT_AUTO: ['Intent', 'DM_INTENT_'],
    DM_STATUS_LATCHED: ['DragStatus', 'DM_STATUS_'], DM_BASIS_PREPARED: ['JointBasis', 'DM_BASIS_'],
    DM_RELEASE_BY_RULE: ['ReleaseFlag', 'DM_RELEASE_'], DM_DEGRADED_NO_KINEMATICS: ['Degraded', 'DM_DEGRADED_'],
    DM_ASSET_NODE_FOLLOWS: ['AssetNodeFlag', 'DM_ASSET_NODE_'], DM_CLIP_NOT_RIGID: ['ClipFlag', 'DM_CLIP_'],
    DM_ASSET_WITHOUT_CLIPS: ['AssetFlag', 'DM_ASSET_'], DM_ASSET_CLIP_LEFT_OUT: ['AssetWarning', 'DM_ASSET_'],
    DM_ASSET_STAYS: ['AssetState', 'DM_ASSET_'], DM_ASSET_INFERRED: ['AssetBasis', 'DM_ASSET_'],
    DM_PIVOT_UNKNOWN: ['PivotKind', 'DM_PIVOT_'],
};

function enumOf({ doc, constants }) {
    const known = enumNames[constants[0].name];
    if (!known) throw new Error(`bindings/js/describe.mjs: the enum of ${constants[0].name} needs a name`);
    return { name: known[0], doc, members: constants.map(c => ({ ...c, name: c.name.replace(known[1], '') })) };
}

function signature(fn) {
    const letters = fn.parameters.map(parameter => parameter.type).concat(fn.returns ?? { name: 'void' })
        .map(type => (type.name === 'void' && !type.pointers ? 'void' : kindOf(type)));
    return `    ${fn.name}: '${letters.slice(0, -1).join(' ')} -> ${letters.at(-1)}',\n`;
}

const enums = ours(api.enums).map(enumOf);
const numbers = ours(api.constants);
const [major, minor, patch, development] = ['MAJOR', 'MINOR', 'PATCH', 'DEVELOPMENT']
    .map(part => numbers.find(c => c.name === `DM_VERSION_${part}`).value);
const version = `${major}.${minor}.${patch}${development ? '-dev' : ''}`;
const versionNumber = (major << 22 | minor << 12 | patch) - development; // as DM_VERSION

let code = NOTE, types = NOTE;
// Of all that C sees, the table of functions too, which has no place below.
const hash = createHash('sha256').update(JSON.stringify([ours(api.structs), ours(api.types), ours(api.functions)])).digest('hex').slice(0, 16);
code += `\n// Hash of the description: ${hash}\n`;
code += `\nexport const VERSION = '${version}';\nexport const VERSION_NUMBER = ${versionNumber};\n`;
types += '\nexport const VERSION: string;\nexport const VERSION_NUMBER: number;\n';
for (const { name, value, doc } of numbers.filter(c => c.name.startsWith('DM_') && !c.name.startsWith('DM_VERSION'))) {
    code += `export const ${name.slice(3)} = ${value};\n`;
    types += `${doc ? `/** ${doc} */\n` : ''}export const ${name.slice(3)}: ${value};\n`;
}
for (const { name, doc, members } of enums) {
    code += `\nexport const ${name} = Object.freeze({\n${members.map(m => `    ${m.name}: ${m.value},\n`).join('')}});\n`;
    types += `\n${doc ? `/** ${doc} */\n` : ''}export const ${name}: {\n${members.map(m =>
        `${m.doc ? `    /** ${m.doc} */\n` : ''}    readonly ${m.name}: ${m.value};\n`).join('')}};\n`;
}
code += `\n// Offset, kind and, of arrays, count of each field; sizes in bytes.\nexport const structs = {\n${[...structs.values()].map(layoutOf).join('')}};\n`;
code += `\n// Parameters and result of each function.\nexport const functions = {\n${ours(api.functions).map(signature).join('')}};\n`;

writeFileSync(join(folder, 'abi.js'), code);
writeFileSync(join(folder, 'abi.d.ts'), types);
